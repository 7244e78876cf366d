#include <utility>

#include "viz/debugger/model/debugger_model.h"

namespace kerf {

void DebuggerModel::drop_object_lanes() {
  if (lanes_.size() > kLanesOfRun) lanes_.resize(kLanesOfRun);
  if (timeline.lane >= lanes_.size()) timeline.lane = 0;
}

void DebuggerModel::show_object_lanes() {
  const auto object = object_in(selection_);
  if (!object) return say("select an object to see its lanes");
  if (lanes_.size() > kLanesOfRun) return;
  bool ended = false;
  ObjectCourse course = run_->course(*object, noticing(ended));
  lanes_.emplace_back("its leaves", std::move(course.leaves));
  lanes_.emplace_back("its pairs", std::move(course.pairs));
  lanes_.emplace_back("its speed", std::move(course.speed));
  ribbons_.reset();
  shown_ribbons_.reset();
  if (ended) say("ended: later steps of the object's lanes are empty");
}

/// The times when the object was there, by its first lane.
void DebuggerModel::add_object_ribbons() {
  if (lanes_.size() == kLanesOfRun) return;
  const Lane& leaves = lanes_[kLanesOfRun];
  for (std::uint32_t step = 1; step <= run_->steps(); ++step) {
    if (!leaves.value(step)) continue;
    const bool goes_on = !ribbons_->empty() && ribbons_->back().last_step + 1 == step;
    if (!goes_on) ribbons_->push_back({step, step, Ribbon::Kind::life});
    ribbons_->back().last_step = step;
  }
}

}  // namespace kerf
