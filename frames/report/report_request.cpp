#include "frames/report/report_request.h"

#include <algorithm>

#include "frames/support/errors.h"
#include "frames/support/parse_number.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

constexpr ReportSizes kFull{.objects = 4250,
                            .steps = 300,
                            .rounds = 3,
                            .scene_objects = 4250,
                            .need_objects = 4250,
                            .loop_objects = 1000,
                            .loop_steps = 1500,
                            .seeds = 16};

/// The named sections, each once, in the order of the page; all if none is named.
std::vector<std::string> chosen(const std::vector<std::string>& named,
                                const std::vector<std::string>& known) {
  for (const std::string& name : named)
    if (std::ranges::find(known, name) == known.end())
      throw UsageError(unknown_name_message("section", name, known));
  std::vector<std::string> sections;
  for (const std::string& name : known)
    if (named.empty() || std::ranges::find(named, name) != named.end()) sections.push_back(name);
  return sections;
}

/// The user's numbers in place of the defaults.
class Overrides {
 public:
  explicit Overrides(ReportRequest& request) : request_(request) {}
  void apply(const char* option, const std::string& text, std::uint32_t least, std::uint32_t most,
             std::initializer_list<std::uint32_t*> sizes) {
    if (text.empty()) return;
    for (std::uint32_t* size : sizes) *size = parse_whole<std::uint32_t>(option, text, least, most);
    request_.options += std::string(" ") + option + " " + text;
  }

 private:
  ReportRequest& request_;
};

}  // namespace

ReportRequest parse_report_request(const ReportTexts& texts, const std::vector<std::string>& known) {
  ReportRequest request;
  request.sections = chosen(texts.sections, known);
  if (texts.full) {
    request.sizes = kFull;
    request.options = " --full";
  }
  ReportSizes& sizes = request.sizes;
  Overrides overrides(request);
  overrides.apply("--objects", texts.objects, 20, 100'000,
                  {&sizes.objects, &sizes.scene_objects, &sizes.need_objects, &sizes.loop_objects});
  overrides.apply("--steps", texts.steps, 10, 100'000, {&sizes.steps, &sizes.loop_steps});
  overrides.apply("--rounds", texts.rounds, 1, 100, {&sizes.rounds});
  overrides.apply("--seeds", texts.seeds, 1, 1000, {&sizes.seeds});
  request.out = texts.out;
  if (request.out.extension() != ".html")
    throw UsageError("--out '" + texts.out + "': call the page something.html");
  request.kept = std::filesystem::path(texts.out).replace_extension(".json");
  if (!texts.shard.empty()) request.shard = parse_shard(texts.shard);
  request.hardcases = texts.hardcases;
  request.fresh = texts.fresh;
  request.overwrite = texts.overwrite;
  return request;
}

}  // namespace kerf
