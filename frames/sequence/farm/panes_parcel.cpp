#include "frames/sequence/farm/panes_parcel.h"

#include <utility>

#include "frames/sequence/farm/frame_parcel.h"
#include "frames/support/raw_bytes.h"

namespace kerf {
namespace {

// Each takes a RawWriter and what it writes, or a RawReader and what it reads.

void pane_fields(auto& bytes, auto& pane) {
  auto& parts = pane.parts;
  bytes(pane.name, parts.kind, parts.holding, parts.is_round, parts.cells, parts.cuts, parts.members);
  bytes.each(parts.lists, [&](auto& list) { bytes(list.axis, list.ends); });
  bytes(parts.tells_tested, parts.unseen, pane.pairs, pane.rejected, pane.figures);
}

void frame_fields(auto& bytes, auto& frame) {
  bytes(frame.has_strips, frame.is_timed, frame.columns);
  bytes.each(frame.panes, [&](auto& pane) { pane_fields(bytes, pane); });
}

}  // namespace

/// The bodies and what belongs to none of the panes travel as a frame does.
template <int D>
std::vector<std::uint8_t> pack_panes(const PanesFrame<D>& frame) {
  FrameInput<D> input;
  input.bodies = frame.bodies;
  input.contacts = frame.contacts;
  input.caption.scene = frame.scene;
  input.caption.step = frame.step;
  input.caption.step_name = frame.step_name;
  input.caption.objects = frame.objects;
  input.caption.moving = frame.moving;
  FramePlan<D> plan;
  plan.bounds = frame.bounds;
  plan.samples = frame.samples;
  RawWriter out;
  out(pack(input, plan));
  frame_fields(out, frame);
  return out.take();
}

template <int D>
PanesFrame<D> unpack_panes(std::span<const std::uint8_t> bytes) {
  RawReader in(bytes);
  FrameParcel<D> parcel = unpack<D>(in.get<std::vector<std::uint8_t>>());
  PanesFrame<D> frame;
  frame.scene = parcel.caption.scene;
  frame.step = parcel.caption.step;
  frame.step_name = parcel.caption.step_name;
  frame.objects = parcel.caption.objects;
  frame.moving = parcel.caption.moving;
  frame.bodies = std::move(parcel.bodies);
  frame.contacts = std::move(parcel.contacts);
  frame.bounds = parcel.plan.bounds;
  frame.samples = parcel.plan.samples;
  frame_fields(in, frame);
  return frame;
}

template std::vector<std::uint8_t> pack_panes<2>(const PanesFrame<2>&);
template std::vector<std::uint8_t> pack_panes<3>(const PanesFrame<3>&);
template PanesFrame<2> unpack_panes<2>(std::span<const std::uint8_t>);
template PanesFrame<3> unpack_panes<3>(std::span<const std::uint8_t>);

}  // namespace kerf
