#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/objects/broad_phase.h"

namespace kerf::test {

/// One request to a broad phase and the answer that ours must give.
template <int D>
struct Request {
  enum class Kind : std::uint8_t { insert, move, remove };
  Kind kind = Kind::insert;
  ObjectId object;
  Box<D> box;
  Mobility mobility = Mobility::moving;
  Status expected = Status::ok;
  /// By how much a volume that is not the box itself reaches beyond the shape in the box.
  double margin = 0;
};

/// What happens before one step.
template <int D>
struct ScriptStep {
  std::string_view config;  ///< "K=V,...": a change of our configuration; none if empty
  std::vector<Request<D>> requests;
};

/// All that is asked of a broad phase, step by step.
template <int D>
using Script = std::vector<ScriptStep<D>>;

/// Writes scripts. Requests are for the step that begins with the last call of `step`.
template <int D>
class ScriptWriter {
 public:
  ScriptWriter() : script_(1) {}

  void insert(std::uint32_t object, const Box<D>& box, Status expected = Status::ok,
              Mobility mobility = Mobility::moving) {
    write({Request<D>::Kind::insert, {object}, box, mobility, expected, margin_});
  }
  void move(std::uint32_t object, const Box<D>& box, Status expected = Status::ok) {
    write({Request<D>::Kind::move, {object}, box, Mobility::moving, expected, margin_});
  }
  void remove(std::uint32_t object, Status expected = Status::ok) {
    write({Request<D>::Kind::remove, {object}, {}, Mobility::moving, expected, 0});
  }
  void configure(std::string_view config) { script_.back().config = config; }
  /// For the requests that follow.
  void set_margin(double margin) { margin_ = margin; }

  /// Ends a step, and `more` further ones in which nothing is asked.
  void step(std::uint32_t more = 0) { script_.resize(script_.size() + 1 + more); }
  /// The script; the requests since the last `step` are dropped.
  Script<D> take() {
    script_.pop_back();
    return std::move(script_);
  }

 private:
  void write(const Request<D>& request) { script_.back().requests.push_back(request); }

  Script<D> script_;
  double margin_ = 0;
};

}  // namespace kerf::test
