#pragma once

#include <cstdint>

#include "core/recording/recording_reader.h"

namespace kerf {

/// How the objects of a recording look after any step; from one step to the next it is quick.
template <int D>
class RecordedLooks {
 public:
  /// The reader must live as long.
  explicit RecordedLooks(RecordingReader<D>& recording) : recording_(recording) {}

  /// Valid until the next call. Throws std::runtime_error for a step that the recording does not have, or if
  /// it is damaged.
  const Looks<D>& at(std::uint32_t step);
  /// How an object looks after the step of the last call.
  [[nodiscard]] Appearance<D> appearance(ObjectId object) const {
    return appearance_of(looks_.of(object), recording_.shapes());
  }

 private:
  RecordingReader<D>& recording_;
  std::uint32_t step_ = 0;
  Looks<D> looks_;
};

}  // namespace kerf
