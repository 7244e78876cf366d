#pragma once

#include <string>
#include <vector>

#include "core/base/config.h"
#include "core/objects/object_table.h"
#include "core/trace/reporter.h"
#include "core/tree/scheduler.h"
#include "core/tree/tree.h"
#include "tests/fuzz/tree/byte_reader.h"
#include "tests/fuzz/tree/machine_report.h"
#include "tests/fuzz/tree/volume_reader.h"

namespace kerf::test {

/// A tree that is driven by bytes. See `run_operator_case`.
template <int D>
class OperatorMachine {
 public:
  OperatorMachine(VolumeKind kind, ByteReader& bytes, MachineReport& report);

  /// Operates until the bytes are spent or something is found.
  void run();

 private:
  void operate();
  void insert();
  void move();
  void move_many();
  void remove();
  void take_over(const std::vector<ObjectId>& changed);
  void divide_leaf(Operator op);
  void change_inner(Operator op);
  void plant_plane();
  void schedule(bool traverse);
  void change_config();
  void shed();
  void refused_without_trace(std::uint64_t hash_before, Operator op);
  void expect_event(const OperatorActed& event);
  void check(bool sorts);
  void compare_pairs();
  NodeId pick(bool leaf);
  void find(const std::string& what);

  ByteReader& bytes_;
  MachineReport& report_;
  VolumeReader<D> volumes_;
  kerf::Tree<D> tree_;
  ObjectTable<D> latest_;
  Scheduler<D> scheduler_;
  Reporter<NoTrace> reporter_;
  Config config_;
  std::vector<Pair> expected_;  ///< the oracle's answer
  bool moved_ = true;           ///< the oracle must be asked again
  std::uint32_t step_ = 0;
  std::string last_;  ///< what was done last
};

}  // namespace kerf::test
