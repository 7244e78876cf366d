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

/// The origin of an algorithm.
enum class Origin : std::uint8_t { kerf, ours, library };

/// The names of the tuned tree and of the paper's.
inline constexpr std::string_view kTunedTree = "kerf";
inline constexpr std::string_view kPaperTree = "kerf-paper";

/// An algorithm for `kerf bench` and for the loop of a scene.
template <int D>
struct Algorithm {
  std::string name;
  std::string what;
  Origin origin = Origin::library;
  unsigned max_threads = 1;
  bool by_default = true;  ///< measured unless the user chooses
  std::function<std::unique_ptr<BroadPhase<D>>(const RivalHints<D>& hints, unsigned threads)> make;
};

/// All of them, ours first.
template <int D>
std::vector<Algorithm<D>> algorithms();

/// The algorithm for a text from the user: a name, and for the trees parameters after colons, for example
/// "kerf:max_threshold=256:free_directions=0", among them those of an `Approximation`:
/// "kerf:period=4:margin=0.2". None if this dimension does not have it. Throws UsageError for parameters that
/// cannot work.
template <int D>
std::optional<Algorithm<D>> find_algorithm(std::string_view text);

/// Throws UsageError, with a suggestion, unless some dimension has that algorithm.
void check_algorithm(std::string_view text);

}  // namespace kerf
