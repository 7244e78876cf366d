#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/objects/broad_phase.h"
#include "frames/rivals/rival.h"

namespace kerf {

/// Whose work an algorithm is.
enum class Origin : std::uint8_t { kerf, ours, library };

/// The names of the tree, tuned and as the paper has it.
inline constexpr std::string_view kTunedTree = "kerf";
inline constexpr std::string_view kPaperTree = "kerf-paper";

/// What `kerf bench` can measure, and what can be the broad phase of a scene.
template <int D>
struct Algorithm {
  std::string name;
  std::string what;
  Origin origin = Origin::library;
  unsigned max_threads = 1;
  bool by_default = true;  ///< measured unless the user says what
  std::function<std::unique_ptr<BroadPhase<D>>(const RivalHints<D>& hints, unsigned threads)> make;
};

/// All of them, ours first.
template <int D>
std::vector<Algorithm<D>> algorithms();

/// The algorithm that a user means: a name, and for the trees parameters after colons, for example
/// "kerf:max_threshold=256:free_directions=0", among them those of an `Approximation`:
/// "kerf:period=4:margin=0.2". Nothing if there is none in this dimension. Throws UsageError for parameters
/// that cannot work.
template <int D>
std::optional<Algorithm<D>> find_algorithm(std::string_view text);

/// Throws UsageError, with a suggestion, unless some dimension has that algorithm.
void check_algorithm(std::string_view text);

}  // namespace kerf
