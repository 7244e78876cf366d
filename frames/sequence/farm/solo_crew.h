#pragma once

#include "frames/sequence/farm/frame_order.h"

namespace kerf {

/// Frames made one after another in the thread that adds them, without any other process.
class SoloCrew final : public FrameCrew {
 public:
  SoloCrew(const StartFrameMaker& start, Deliver deliver) : maker_(start()), deliver_(std::move(deliver)) {}

  void add(FrameOrder order) override {
    const FrameMaker::Made made = maker_->make(order.record.file, order.parcel, order.kept);
    order.record.pixel_hash = made.pixel_hash;
    deliver_(order.record, *made.image);
  }
  void finish() override {}

 private:
  std::unique_ptr<FrameMaker> maker_;
  Deliver deliver_;
};

}  // namespace kerf
