#include "frames/commands/test_of_scenario.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

namespace kerf {
namespace {

constexpr std::string_view kMark = "// Made by `kerf minimize`";

std::string number(Scalar x) {
  if (std::isnan(x)) return "std::numeric_limits<float>::quiet_NaN()";
  if (std::isinf(x)) return std::string(x < 0 ? "-" : "") + "std::numeric_limits<float>::infinity()";
  std::array<char, 32> digits{};
  std::string text(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "F";
}

template <int D>
std::string vector_text(const Vector<D>& v) {
  std::string text = "{{";
  for (int axis = 0; axis < D; ++axis) text += (axis == 0 ? "" : ", ") + number(v[axis]);
  return text + "}}";
}

template <int D>
std::string box_code(const Box<D>& box) {
  return "Box{" + vector_text(box.min) + ", " + vector_text(box.max) + "}";
}

template <int D>
class TestText {
 public:
  explicit TestText(const Scenario<D>& scenario) : scenario_(scenario) {}

  std::string run(const std::string& condition, std::uint64_t hash) {
    text_ = head(condition);
    for (std::size_t k = 0; k < scenario_.steps.size(); ++k) {
      text_ += "  // step " + step_name(k) + "\n";
      add_step(scenario_.steps[k].requests);
      if (k > 0 && scenario_.steps[k].config != scenario_.steps[k - 1].config)
        text_ += "  set_config(\"" + to_string(scenario_.steps[k].config) + "\");\n";
      text_ += "  step();\n";
    }
    return text_ + "  EXPECT_EQ(tree.state_hash(), 0x" + to_hex(hash) + "U);\n}\n";
  }

 private:
  [[nodiscard]] std::string step_name(std::size_t k) const {
    return scenario_.info.names.names_steps() ? scenario_.steps[k].name : std::to_string(k + 1);
  }

  [[nodiscard]] std::string head(const std::string& condition) const {
    const std::string d = std::to_string(D);
    const std::string kind =
        "*kerf::parse_volume_kind<" + d + ">(\"" + std::string(to_string(scenario_.info.volume)) + "\")";
    return std::string(kMark) + ": after its last step holds\n//   " + condition +
           "\n#include <gtest/gtest.h>\n\n#include <algorithm>\n#include <limits>\n#include <vector>\n\n"
           "#include \"core/broad_phase/brute_force.h\"\n#include \"core/bsp/bsp.h\"\n"
           "#include \"core/recording/step_requests.h\"\n\n"
           "TEST(Minimized, " +
           std::string(D == 2 ? "In2D" : "In3D") +
           ") {\n"
           "  using Box = kerf::Box<" +
           d +
           ">;\n"
           "  constexpr auto kMoving = kerf::Mobility::moving;\n  constexpr auto kFixed = "
           "kerf::Mobility::fixed;\n"
           "  kerf::Config config;\n  kerf::apply(config, \"" +
           to_string(scenario_.steps.front().config) +
           "\");\n"
           "  const kerf::VolumeKind kind = " +
           kind +
           ";\n"
           "  kerf::Bsp<" +
           d + "> tree(config, kind);\n  kerf::BruteForce<" + d +
           "> oracle(kind);\n"
           "  const auto volume = [&](const Box& box, const std::vector<float>& extra) {\n"
           "    return kerf::volume_from<" +
           d +
           ">(kind, box, extra.data());\n  };\n"
           "  const auto both = [&](auto call) {\n    call(tree);\n    call(oracle);\n  };\n"
           "  const auto insert = [&](std::uint32_t id, const auto& bound, kerf::Mobility mobility) {\n"
           "    both([&](auto& b) { (void)b.insert(kerf::ObjectId{id}, bound, mobility); });\n  };\n"
           "  const auto move = [&](std::uint32_t id, const auto& bound) {\n"
           "    both([&](auto& b) { (void)b.move(kerf::ObjectId{id}, bound); });\n  };\n"
           "  const auto move_many = [&](const std::vector<kerf::ObjectId>& ids, const std::vector<Box>& "
           "boxes) {\n"
           "    both([&](auto& b) { (void)b.move_many(ids, boxes); });\n  };\n"
           "  const auto remove = [&](std::uint32_t id) { both([&](auto& b) { "
           "(void)b.remove(kerf::ObjectId{id}); }); };\n"
           "  const auto sorted = [](const auto& b) {\n"
           "    std::vector<kerf::Pair> pairs;\n"
           "    for (const kerf::Pair& pair : b.pairs()) pairs.push_back(kerf::make_pair(pair.a, pair.b));\n"
           "    std::ranges::sort(pairs);\n    return pairs;\n  };\n"
           "  const auto step = [&] {\n    both([](auto& b) { b.step(); });\n"
           "    EXPECT_EQ(sorted(tree), sorted(oracle));\n  };\n"
           "  const auto set_config = [&](const char* text) {\n    kerf::Config changed;\n    "
           "kerf::apply(changed, "
           "text);\n    tree.set_config(changed);\n  };\n"
           "  (void)kMoving, (void)kFixed, (void)volume, (void)insert, (void)move, (void)move_many, "
           "(void)remove, (void)set_config;\n\n";
  }

  void add_step(const StepRequests<D>& requests) {
    std::size_t k = 0;
    const Scalar* extra = requests.extra.data();
    for (const Call& call : requests.calls) {
      const std::size_t end = k + call.count;
      if (call.kind == RequestKind::move_boxes) add_group(requests, k, end);
      for (; k < end; ++k) {
        if (call.kind != RequestKind::move_boxes)
          add_call(call, requests.objects[k], requests.boxes[k], extra);
        if (has_volume(call.kind)) extra += extra_size<D>(scenario_.info.volume);
      }
    }
  }

  void add_group(const StepRequests<D>& requests, std::size_t begin, std::size_t end) {
    std::string ids;
    std::string boxes;
    for (std::size_t k = begin; k < end; ++k) {
      ids += (k == begin ? "{" : ", {") + std::to_string(requests.objects[k].value) + "}";
      boxes += (k == begin ? "" : ", ") + box_code(requests.boxes[k]);
    }
    text_ += "  move_many({" + ids + "}, {" + boxes + "});\n";
  }

  void add_call(const Call& call, ObjectId object, const Box<D>& box, const Scalar* extra) {
    const std::string id = std::to_string(object.value);
    if (call.kind == RequestKind::remove) {
      text_ += "  remove(" + id + ");\n";
      return;
    }
    const std::string bound = has_volume(call.kind) ? volume_code(box, extra) : box_code(box);
    if (is_insert(call.kind)) {
      text_ += "  insert(" + id + ", " + bound +
               (call.mobility == Mobility::fixed ? ", kFixed" : ", kMoving") + ");\n";
    } else {
      text_ += "  move(" + id + ", " + bound + ");\n";
    }
  }

  [[nodiscard]] std::string volume_code(const Box<D>& box, const Scalar* extra) const {
    std::string numbers;
    for (int k = 0; k < extra_size<D>(scenario_.info.volume); ++k)
      numbers += (k == 0 ? "" : ", ") + number(extra[k]);
    return "volume(" + box_code(box) + ", {" + numbers + "})";
  }

  const Scenario<D>& scenario_;
  std::string text_;
};

}  // namespace

template <int D>
std::string test_of_scenario(const Scenario<D>& scenario, const std::string& condition, std::uint64_t hash) {
  return TestText<D>(scenario).run(condition, hash);
}

bool is_test_of_scenario(const std::filesystem::path& file) {
  std::string head(kMark.size(), '\0');
  std::ifstream stream(file, std::ios::binary);
  return stream.read(head.data(), static_cast<std::streamsize>(head.size())) && head == kMark;
}

template std::string test_of_scenario<2>(const Scenario<2>&, const std::string&, std::uint64_t);
template std::string test_of_scenario<3>(const Scenario<3>&, const std::string&, std::uint64_t);

}  // namespace kerf
