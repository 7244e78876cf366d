#include "frames/sequence/farm/panes_parcel.h"

#include <utility>

#include "frames/sequence/farm/frame_parcel.h"
#include "frames/support/raw_bytes.h"

namespace kerf {
namespace {

template <class T>
void put(RawWriter& out, const std::vector<T>& list) {
  out.put_list(std::span<const T>(list));
}

template <int D>
void write(RawWriter& out, const StructureParts<D>& parts) {
  out.put_text(parts.kind);
  out.put(parts.holding);
  put(out, parts.cells);
  put(out, parts.cuts);
  put(out, parts.members);
  out.put(parts.lists.size());
  for (const AxisList& list : parts.lists) {
    out.put(list.axis);
    put(out, list.ends);
  }
  out.put(parts.tells_tested);
  out.put_text(parts.unseen);
}

template <int D>
StructureParts<D> read_parts(RawReader& in) {
  StructureParts<D> parts;
  parts.kind = in.get_text();
  parts.holding = in.get<Holding>();
  parts.cells = in.get_list<StructureCell<D>>();
  parts.cuts = in.get_list<Cut<D>>();
  parts.members = in.get_list<CellMember>();
  for (std::size_t lists = in.get<std::size_t>(); lists > 0; --lists) {
    const int axis = in.get<int>();
    parts.lists.push_back({axis, in.get_list<AxisEnd>()});
  }
  parts.tells_tested = in.get<bool>();
  parts.unseen = in.get_text();
  return parts;
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
  put(out, pack(input, plan));
  out.put(frame.has_strips);
  out.put(frame.is_timed);
  out.put(frame.columns);
  out.put(frame.panes.size());
  for (const StructurePane<D>& pane : frame.panes) {
    out.put_text(pane.name);
    write(out, pane.parts);
    put(out, pane.pairs);
    put(out, pane.rejected);
    out.put(pane.figures);
  }
  return out.take();
}

template <int D>
PanesFrame<D> unpack_panes(std::span<const std::uint8_t> bytes) {
  RawReader in(bytes);
  FrameParcel<D> parcel = unpack<D>(in.get_list<std::uint8_t>());
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
  frame.has_strips = in.get<bool>();
  frame.is_timed = in.get<bool>();
  frame.columns = in.get<int>();
  for (std::size_t panes = in.get<std::size_t>(); panes > 0; --panes) {
    StructurePane<D> pane;
    pane.name = in.get_text();
    pane.parts = read_parts<D>(in);
    pane.pairs = in.get_list<Pair>();
    pane.rejected = in.get_list<Pair>();
    pane.figures = in.get<PaneFigures>();
    frame.panes.push_back(std::move(pane));
  }
  return frame;
}

template std::vector<std::uint8_t> pack_panes<2>(const PanesFrame<2>&);
template std::vector<std::uint8_t> pack_panes<3>(const PanesFrame<3>&);
template PanesFrame<2> unpack_panes<2>(std::span<const std::uint8_t>);
template PanesFrame<3> unpack_panes<3>(std::span<const std::uint8_t>);

}  // namespace kerf
