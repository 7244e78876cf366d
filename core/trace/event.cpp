#include "core/trace/event.h"

#include "core/base/counted.h"
#include "core/base/overloaded.h"

namespace kerf {
namespace {

std::string name(NodeRef ref) { return "n" + std::to_string(ref.node.value); }

std::string text(const Quality& q) {
  std::string all = std::to_string(q.population);
  if (q.left == 0 && q.right == 0) return all;
  return all + " (" + std::to_string(q.left) + " | " + std::to_string(q.right) + ")";
}

std::string describe(const EventBody& body, const GivenNames& names) {
  const auto acted = [](const OperatorActed& e) {
    return std::string(to_string(e.op)) + " " + name(e.node) + ": " + text(e.before) + " -> " + text(e.after);
  };
  const auto refused = [](const OperatorRefused& e) {
    return std::string(to_string(e.op)) + " " + name(e.node) +
           " refused: " + std::string(to_string(e.reason));
  };
  return std::visit(
      Overloaded{
          [](const PhaseBegan& e) { return "phase " + std::string(to_string(e.phase)); },
          [&](const ObjectPlaced& e) {
            return "object " + names.object(e.object) + " in " + counted(e.leaves, "leaf", "leaves");
          },
          [](const OperatorScheduled& e) {
            return std::string(to_string(e.op)) + " " + name(e.node) + " scheduled";
          },
          acted,
          refused,
          [](const EventsDeferred& e) { return counted(e.count, "event") + " deferred"; },
          [](const AllPlaced& e) { return "all " + counted(e.objects, "object") + " placed anew"; },
      },
      body);
}

}  // namespace

std::string_view to_string(Operator op) {
  switch (op) {
    case Operator::balance:
      return "balance";
    case Operator::shift_split:
      return "shift-split";
    case Operator::split:
      return "split";
    case Operator::swap:
      return "swap";
    case Operator::merge:
      return "merge";
  }
  return "";
}

std::string_view to_string(Refusal refusal) {
  switch (refusal) {
    case Refusal::dead_node:
      return "the node is dead";
    case Refusal::not_needed:
      return "no longer needed";
    case Refusal::no_partitioner:
      return "no good partitioner";
    case Refusal::height:
      return "the height cap";
    case Refusal::entries:
      return "the cap on entries";
    case Refusal::list_full:
      return "the event list is full";
    case Refusal::decided:
      return "refused by a decision";
  }
  return "";
}

std::string_view to_string(Phase phase) {
  switch (phase) {
    case Phase::place:
      return "place";
    case Phase::sort:
      return "sort";
    case Phase::schedule:
      return "schedule";
    case Phase::operate:
      return "operate";
    case Phase::sweep:
      return "sweep";
  }
  return "";
}

std::string describe(const Event& event, const GivenNames& names) {
  return "e" + std::to_string(event.id) + " step " + names.step(event.step) + " " +
         describe(event.body, names);
}

}  // namespace kerf
