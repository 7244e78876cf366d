#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/counted.h"
#include "core/files/part_file.h"
#include "core/files/whole_file.h"
#include "frames/commands/command.h"
#include "frames/diff/diff_page.h"
#include "frames/diff/diff_result.h"
#include "frames/diff/frame_diff.h"
#include "frames/sequence/draw_list_file.h"
#include "frames/sequence/sidecar.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_number.h"
#include "frames/support/progress.h"
#include "frames/support/suggest.h"
#include "viz/image/stored_picture.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

/// Builds the new files of one frame beside their references before one of those is replaced. Ids that no
/// longer belong to the picture must not stay beside it. The picture comes last: after an
/// interruption in between the difference is still found.
void replace(const fs::path& test, const fs::path& reference) {
  std::vector<std::unique_ptr<PartFile>> parts;
  std::vector<fs::path> outdated;
  const auto add = [&](const fs::path& from, const fs::path& to) {
    if (!fs::exists(from)) return outdated.push_back(to);
    parts.push_back(std::make_unique<PartFile>(to));
    parts.back()->write(read_whole_file(from));
  };
  add(ids_path(test), ids_path(reference));
  add(draw_list_path(test), draw_list_path(reference));
  add(test, reference);
  for (const fs::path& file : outdated) fs::remove(file);
  for (const auto& part : parts) part->keep();
}

fs::path reference_of(const FrameDiff& diff, const DiffResult& result) {
  if (!diff.frame.is_extra()) return diff.frame.reference;
  return fs::is_directory(result.test) ? result.reference / diff.frame.name : result.reference;
}

/// "x.png", and where it was put if that is elsewhere.
std::string name_of(const FrameDiff& diff, const fs::path& to) {
  return diff.frame.name + (fs::is_symlink(to) ? " (a link to " + fs::canonical(to).string() + ")" : "");
}

bool is_to_be_approved(const FrameDiff& diff) { return !diff.same && !diff.frame.is_missing(); }

void check(const fs::path& frame) {
  try {
    (void)read_stored_picture(frame);
    (void)read_ids(frame);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(error.what()) + "; nothing was approved");
  }
}

/// Replaces the reference of each frame that differs by the new frame, with its ids; equal frames, and
/// references without a frame, are left alone. Returns the names of the replaced ones. Throws UnusableInput
/// before anything is written if one of them is no whole picture, std::runtime_error if one cannot be
/// written. `stop` is asked before each frame; where it says so, that and the following ones are left alone.
std::vector<std::string> approve_frames(const DiffResult& result, const std::function<bool()>& stop) {
  Outputs outputs({}, true);
  for (const FrameDiff& diff : result.frames) {
    if (!is_to_be_approved(diff)) continue;
    if (stop()) return {};
    check(diff.frame.test);
    outputs.add_file(reference_of(diff, result));
  }
  std::vector<std::string> approved;
  for (const FrameDiff& diff : result.frames) {
    if (!is_to_be_approved(diff)) continue;
    if (stop()) break;
    const fs::path to = reference_of(diff, result);
    if (to.has_parent_path()) fs::create_directories(to.parent_path());
    replace(diff.frame.test, to);
    approved.push_back(name_of(diff, to));
  }
  return approved;
}

/// The same for the manifests that differ, unless there is none of the new frames, or a frame of its folder
/// is missing.
std::vector<std::string> approve_manifests(const DiffResult& result) {
  std::vector<std::string> approved;
  Outputs outputs({}, true);
  for (const ManifestDiff& manifest : result.manifests) {
    const fs::path to = result.reference / manifest.name;
    const bool lacks_a_frame = std::ranges::any_of(result.frames, [&](const FrameDiff& diff) {
      return diff.frame.is_missing() && diff.frame.reference.parent_path() == to.parent_path();
    });
    if (manifest.test.empty() || lacks_a_frame) continue;
    outputs.add_file(to);
    PartFile part(to);
    part.write(read_whole_file(manifest.test));
    part.keep();
    approved.push_back(manifest.name);
  }
  return approved;
}

constexpr const char* kDiffFooter =
    "REFERENCE and TEST are two PNG files or two folders, whose frames are matched by name. Beside frames "
    "drawn\n"
    "with --ids lie NAME.ids.png and NAME.draw.json: differences then have names (plane n17 missing).\n"
    "GATES   auto   exact, or flip where the draw lists name two rasterisers (the default)\n"
    "        exact  every pixel is the same: for pictures of one rasteriser\n"
    "        ids    the same things were drawn at the same place in the same colours\n"
    "        flip   no person would see a difference: FLIP's maximum is small and, where there are ids, they "
    "agree";

DiffRules parse_rules(const std::string& gate, const std::string& limit) {
  DiffRules rules;
  std::vector<std::string> names;
  for (const DiffGate known : kDiffGates) {
    names.emplace_back(to_string(known));
    if (gate == names.back()) rules.gate = known;
  }
  if (!gate.empty() && gate != to_string(rules.gate))
    throw UsageError("--gate: " + unknown_name_message("gate", gate, names));
  if (limit.empty()) return rules;
  const auto number = parse_number<double>(limit);
  if (!number || !(*number >= 0 && *number <= 1))
    throw UsageError("--flip-limit '" + limit + "' is not a number from 0 to 1");
  if (rules.gate == DiffGate::exact || rules.gate == DiffGate::ids)
    throw UsageError("--flip-limit has no meaning for --gate " + gate + "; leave one of them out");
  rules.flip_limit = *number;
  return rules;
}

DiffResult compare(const std::string& reference, const std::string& test, const DiffRules& rules,
                   WithoutReferences without) {
  const InterruptGuard interrupt;
  const ProgressLine progress;
  PairedFrames paired = pair_frames(reference, test, without);
  DiffResult result{reference,
                    test,
                    rules,
                    {},
                    std::move(paired.notes),
                    std::move(paired.faults),
                    std::move(paired.manifests)};
  for (const FramePair& frame : paired.frames) {
    if (interrupt.requested())
      throw Interrupted("interrupted after " + std::to_string(result.frames.size()) + " of " +
                        counted(paired.frames.size(), "frame") + "; nothing was proved");
    progress.show("comparing frame " + std::to_string(result.frames.size() + 1) + " of " +
                  std::to_string(paired.frames.size()));
    result.frames.push_back(diff_frame(frame, rules));
  }
  return result;
}

void approve(const DiffResult& result) {
  const InterruptGuard interrupt;  // before there is a part of a file that an interrupt would leave
  const std::vector<std::string> approved = approve_frames(result, [&] { return interrupt.requested(); });
  for (const std::string& name : approved) std::fprintf(stderr, "approved %s\n", name.c_str());
  if (interrupt.requested())
    throw Interrupted("interrupted: " + counted(approved.size(), "frame was", "frames were") + " approved");
  std::fprintf(stderr, "%s approved\n", counted(approved.size(), "frame").c_str());
  if (!result.faults.empty())
    throw std::runtime_error("frames were approved, but not all that lies there was compared");
  for (const std::string& name : approve_manifests(result))
    std::fprintf(stderr, "approved %s\n", name.c_str());
  const auto missing =
      std::ranges::count_if(result.frames, [](const FrameDiff& diff) { return diff.frame.is_missing(); });
  if (missing > 0)
    throw DoesNotHold(std::to_string(missing) + " of the references " +
                      (missing == 1 ? "has no frame and was" : "have no frame and were") + " left alone");
  for (const ManifestDiff& manifest : result.manifests)
    if (manifest.test.empty()) throw DoesNotHold(manifest.reference.string() + " was left alone");
}

class DiffCommand final : public Command {
 public:
  explicit DiffCommand(CLI::App& program);
  void run() const override;

 private:
  std::string reference_;
  std::string test_;
  std::string gate_;
  std::string flip_limit_;
  std::string report_;
  bool json_ = false;
  bool overwrite_ = false;
  bool approve_ = false;
};

DiffCommand::DiffCommand(CLI::App& program) : Command(program, "diff", "Find what differs between pictures") {
  option("REFERENCE", reference_, "What is right: a PNG or a folder", "")->required();
  option("TEST", test_, "What is in question", "")->required();
  option("--gate", gate_, "What counts as the same, see below", "NAME");
  option("--flip-limit", flip_limit_, "Largest FLIP that the gate flip allows, 0 to 1", "X");
  output("--report", report_, "Also a page that shows what differs: DIR/index.html", "DIR");
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier page");
  command_->add_flag("--json", json_, "As JSON");
  command_->add_flag(
      "--approve", approve_,
      "Afterwards put the frames of TEST that differ, and only those, in place of their references");
  command_->footer(kDiffFooter);
}

void DiffCommand::run() const {
  const DiffRules rules = parse_rules(gate_, flip_limit_);
  const std::filesystem::path page =
      report_.empty() ? std::filesystem::path() : std::filesystem::path(report_) / "index.html";
  Outputs outputs({reference_, test_}, overwrite_);
  outputs.add_folder(report_);
  outputs.add_file(page);
  if (!report_.empty()) make_writable_folder(report_, "--report");
  const DiffResult result =
      compare(reference_, test_, rules, approve_ ? WithoutReferences::accept : WithoutReferences::refuse);
  std::fputs((json_ ? to_json(result) : to_text(result)).c_str(), stdout);
  if (!report_.empty()) {
    write_file_atomically(page, diff_page(result), outputs.replace());
    std::fprintf(stderr, "look at %s/index.html\n", report_.c_str());
  }
  if (approve_) return approve(result);
  if (!result.is_usable()) throw std::runtime_error(summary_line(result));
  if (!result.is_same()) throw DoesNotHold(summary_line(result));
}

}  // namespace

AnyCommand make_diff_command(CLI::App& program) { return std::make_unique<DiffCommand>(program); }

}  // namespace kerf
