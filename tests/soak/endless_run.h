#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/trace/statistics.h"

namespace kerf::test {

/// The pairs of a step were not the oracle's.
class NotExact : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Something that moves for as long as one likes, and the tree that follows it.
class EndlessRun {
 public:
  EndlessRun() = default;
  EndlessRun(const EndlessRun&) = delete;
  EndlessRun& operator=(const EndlessRun&) = delete;
  virtual ~EndlessRun() = default;

  /// One step on; returns the seconds of this thread's processor time that the tree took for it.
  virtual double step() = 0;
  [[nodiscard]] virtual Statistics statistics() const = 0;
  /// Throws NotExact unless the pairs of the last step are the oracle's.
  virtual void ask_oracle() const = 0;
};

/// All that `make_endless_run` knows.
std::vector<std::string> endless_run_names();

/// The run called `name`: a scene of `kerf scenes` or, as "bench:NAME-2d" and "bench:NAME-3d", one of `kerf
/// bench`. Objects of a scene that grows come over the first `growth` steps; after that the oldest falls anew
/// every few steps, so that nothing comes to rest. Throws UsageError for an unknown name.
std::unique_ptr<EndlessRun> make_endless_run(const std::string& name, const Config& config,
                                             std::uint32_t objects, std::uint32_t growth);

}  // namespace kerf::test
