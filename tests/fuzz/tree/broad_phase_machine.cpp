#include <string>

#include "core/broad_phase/brute_force.h"
#include "core/bsp/bsp.h"
#include "core/tree/validate.h"
#include "tests/fuzz/tree/config_reader.h"
#include "tests/fuzz/tree/machine_report.h"
#include "tests/fuzz/tree/volume_reader.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

constexpr std::uint32_t kIds = 48;

/// A broad phase that is driven by bytes, beside the oracle and beside itself with a trace.
template <int D>
class BroadPhaseMachine {
 public:
  BroadPhaseMachine(VolumeKind kind, ByteReader& bytes, MachineReport& report)
      : bytes_(bytes),
        report_(report),
        volumes_(kind, bytes),
        config_(small_tree_config()),
        subject_(config_, kind),
        watched_(config_, kind),
        oracle_(kind) {}

  void run() {
    while (!bytes_.is_spent() && report_.finding.empty()) {
      ++report_.requests;
      request();
    }
    const Statistics statistics = subject_.statistics();
    for (std::size_t op = 0; op < statistics.operators.size(); ++op)
      report_.acted[op] += statistics.operators[op];
    report_.refused += statistics.refused;
  }

 private:
  void request() {
    const std::uint32_t code = bytes_.below(16);
    if (code < 5) return insert();
    if (code < 9)
      return on_all("move",
                    [object = any(), volume = volumes_.read()](auto& b) { return b.move(object, volume); });
    if (code < 11) return on_all("remove", [object = any()](auto& b) { return b.remove(object); });
    if (code < 14) return step();
    if (code < 15) return change_config();
    const Box<D> box = volumes_.read().box;
    on_all("move of a box", [object = any(), box](auto& b) { return b.move(object, box); });
  }

  void insert() {
    const ObjectId object = any();
    const Mobility mobility = bytes_.below(8) == 0 ? Mobility::fixed : Mobility::moving;
    const Volume<D> volume = volumes_.read();
    on_all("insert", [&](auto& b) { return b.insert(object, volume, mobility); });
  }

  ObjectId any() {
    const std::uint32_t id = bytes_.below(kIds + 1);
    return id == kIds ? ObjectId::none() : ObjectId{id};
  }

  /// All broad phases must answer a request alike.
  template <class Request>
  void on_all(const char* what, Request request) {
    const Status expected = request(oracle_);
    if (request(subject_) != expected || request(watched_) != expected)
      find(std::string(what) + ": another status");
  }

  void change_config() {
    change_parameter(config_, bytes_);
    subject_.set_config(config_);
    watched_.set_config(config_);
  }

  void step() {
    subject_.step();
    watched_.step();
    oracle_.step();
    ++report_.comparisons;
    ++report_.validations;
    report_.pairs += oracle_.pairs().size();
    const std::string wrong = difference(subject_.pairs(), oracle_.pairs());
    if (!wrong.empty()) find(wrong);
    for (const Violation& violation : validate(subject_.tree())) find(violation.what);
    if (subject_.state_hash() != watched_.state_hash()) find("a watched run is another run");
    if (!std::ranges::equal(subject_.pairs(), watched_.pairs()))
      find("a watched run has another order of pairs");
    for (const Event& event : watched_.trace().take()) {
      if (event.id != next_event_++ || event.step != subject_.steps()) find("an event has a wrong number");
    }
  }

  void find(const std::string& what) {
    if (report_.finding.empty()) {
      report_.finding = std::to_string(D) + "D " + std::string(to_string(subject_.volume_kind())) +
                        ", step " + std::to_string(subject_.steps()) + ": " + what;
    }
  }

  ByteReader& bytes_;
  MachineReport& report_;
  VolumeReader<D> volumes_;
  Config config_;
  Bsp<D> subject_;
  Bsp<D, EventLog> watched_;
  BruteForce<D> oracle_;
  std::uint64_t next_event_ = 0;
};

template <int D>
void run_case(ByteReader& bytes, MachineReport& report) {
  const auto kinds = volume_kinds<D>();
  BroadPhaseMachine<D>(kinds[bytes.below(static_cast<std::uint32_t>(kinds.size()))], bytes, report).run();
}

}  // namespace

void run_broad_phase_case(CaseBytes bytes, MachineReport& report) {
  ByteReader reader(bytes);
  ++report.cases;
  report.finding.clear();
  if (reader.below(2) == 0)
    run_case<2>(reader, report);
  else
    run_case<3>(reader, report);
}

std::string broad_phase_case(CaseBytes bytes) {
  MachineReport report;
  run_broad_phase_case(bytes, report);
  return report.finding;
}

}  // namespace kerf::test
