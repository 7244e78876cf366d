#include "frames/python/run.h"

#include <stdexcept>

#include "core/base/counted.h"
#include "frames/python/errors.h"

namespace kerf::python {
namespace {

template <int D>
RecordingInfo info_of(const Config& config) {
  RecordingInfo info;
  info.dimension = D;
  info.config = config;
  info.scene = "python";
  return info;
}

}  // namespace

template <int D>
Run<D>::Recorded::Recorded(const Config& config, const std::filesystem::path& path, bool overwrite)
    : part(path, replace_if(overwrite)), bsp(config) {
  recorder.emplace(bsp, part.path(), info_of<D>(config));
}

template <int D>
Run<D>::Run(const Config& config, const std::filesystem::path& record, bool overwrite) {
  if (record.empty()) {
    quiet_ = std::make_unique<Bsp<D>>(config);
    quiet_->time_phases(true);
  } else {
    recorded_ = std::make_unique<Recorded>(config, record, overwrite);
  }
}

/// Without a step there is nothing to keep: the call that made the run may have failed. Where keeping fails,
/// the part that was written stays beside the name.
template <int D>
Run<D>::~Run() {
  if (!recorded_ || recorded_->part.is_done() || steps() == 0) return;
  try {
    if (!is_torn_) close();
    recorded_->recorder.reset();
    if (is_torn_ && !recorded_->part.steps().empty()) (void)recorded_->part.keep_as_far_as_it_came();
  } catch (const std::exception&) {
    recorded_->part.leave();
  }
}

template <int D>
BroadPhase<D>& Run<D>::broad_phase() {
  if (is_torn_)
    throw std::runtime_error(
        "an earlier call failed half-way, so its objects are no more known: make a new BroadPhase");
  if (!recorded_) return *quiet_;
  if (!recorded_->recorder)
    throw std::runtime_error("the recording is complete, and nothing can be added: make a new BroadPhase");
  return *recorded_->recorder;
}

template <int D>
template <class Work>
void Run<D>::write(Work work) {
  of_recording([&] {
    recorded_->part.write([&] {
      try {
        work();
      } catch (...) {
        recorded_->recorder.reset();  // what was committed can be read then
        throw;
      }
    });
  });
}

template <int D>
void Run<D>::step() {
  (void)broad_phase();  // throws if nothing can be asked any more
  const auto take_step = [this] { change(0, [](BroadPhase<D>& broad_phase) { broad_phase.step(); }); };
  if (!recorded_) return take_step();
  write([&] {
    take_step();
    (void)recorded_->bsp.trace().take();
  });
  requests_ = 0;
}

template <int D>
std::string Run<D>::left_out() const {
  if (!recorded_ || !recorded_->recorder || is_torn_ || requests_ == 0) return "";
  return counted(requests_, "request") + " after step " + std::to_string(steps()) +
         " will not be in the recording: a step writes down what was asked before it";
}

template <int D>
void Run<D>::set_threads(unsigned threads) {
  if (recorded_) {
    recorded_->bsp.set_threads(threads);
  } else {
    quiet_->set_threads(threads);
  }
}

template <int D>
void Run<D>::exchange_pairs(PairBuffer& buffer) {
  if (recorded_) {
    recorded_->bsp.exchange_pairs(buffer);
  } else {
    quiet_->exchange_pairs(buffer);
  }
}

template <int D>
void Run<D>::close() {
  if (!recorded_ || !recorded_->recorder) return;
  write([this] {
    recorded_->recorder->finish();
    recorded_->recorder.reset();
    recorded_->part.keep();
  });
}

template class Run<2>;
template class Run<3>;

}  // namespace kerf::python
