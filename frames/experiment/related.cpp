#include "frames/experiment/related.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/base/median.h"
#include "frames/catalog/algorithm.h"
#include "frames/page/short_number.h"

namespace kerf {
namespace {

constexpr std::array<std::string_view, 14> kRelated{
    kPaperTree,           "rebuilt-tree",     "reinserting-tree",     "auxiliary-planes", "shifting-cuts",
    "shifting-cuts-only", "kinetic-tree",     "self-organising-tree", "loose-octree",     "multi-level-hash",
    "sphere-tree",        "fixed-directions", "principal-components", "evolved-planes"};

constexpr std::string_view kAsAWhole = "half as much again as the paper's tree's";
constexpr std::string_view kAlone =
    "half as much again as for the same tree with the best of 2 sqrt(n) directions at each node";
constexpr double kMuch = 1.5;  // "expensive", "degradation": by no less than this factor

constexpr std::array<RelatedClaim, 11> kRelatedClaims{{
    {"a brute-force approach simply deletes moving objects and inserts them again", RelatedMeasure::none, "",
     "", true, 1, kNoFigure},
    {"hash tables require re-applying a hash function to index extents at different levels",
     RelatedMeasure::none, "", "", true, 1, kNoFigure},
    {"loose octrees reduce update costs", RelatedMeasure::update, "loose-octree", "reinserting-tree", false,
     1, "less than to reinsert what moves"},
    {"auxiliary plane cuts minimise the impact of moving objects", RelatedMeasure::update, "auxiliary-planes",
     "rebuilt-tree", false, 1, "less than to build the whole tree"},
    {"periodic reconstruction of the tree is necessary due to degradation", RelatedMeasure::degradation,
     "shifting-cuts-only", "rebuilt-tree", true, kMuch,
     "never built anew, it compares half as many pairs again as a new tree at the end of the run"},
    {"the best solution is a self-organising structure", RelatedMeasure::total, "self-organising-tree",
     "rebuilt-tree", false, 1, "faster than a tree built anew"},
    {"kinetic updates can be expensive, issued at every continuous change", RelatedMeasure::update,
     "kinetic-tree", kPaperTree, true, kMuch, kAsAWhole},
    {"principal components are too expensive for highly dynamic scenes", RelatedMeasure::update,
     "principal-components", kPaperTree, true, kMuch, kAsAWhole},
    {"principal components are expensive: the choice of a plane alone", RelatedMeasure::update,
     "principal-components", "fixed-directions", true, kMuch, kAlone},
    {"evolutionary techniques are too expensive for highly dynamic scenes", RelatedMeasure::update,
     "evolved-planes", kPaperTree, true, kMuch, kAsAWhole},
    {"evolutionary techniques are expensive: the choice of a plane alone", RelatedMeasure::update,
     "evolved-planes", "fixed-directions", true, kMuch, kAlone},
}};

std::size_t place_of(std::string_view contestant) {
  const auto* const found = std::ranges::find(kRelated, contestant);
  if (found == kRelated.end()) throw std::logic_error("no such contestant");
  return static_cast<std::size_t>(found - kRelated.begin());
}

double sum_of(const RelatedRun& run, std::size_t contestant, double RelatedFigures::*figure) {
  double sum = 0;
  for (const RelatedFigures& part : run.parts[contestant]) sum += part.*figure;
  return sum;
}

double figure_of(const RelatedRun& run, std::string_view contestant, RelatedMeasure measure) {
  const std::size_t place = place_of(contestant);
  if (measure == RelatedMeasure::degradation) return run.parts[place].back().candidates;
  const double update = sum_of(run, place, &RelatedFigures::update);
  return measure == RelatedMeasure::update ? update : update + sum_of(run, place, &RelatedFigures::collision);
}

/// Subject over rival, rising, one for each run.
std::vector<double> ratios_of(const RelatedClaim& claim, const std::vector<RelatedRun>& runs) {
  std::vector<double> ratios;
  for (const RelatedRun& run : runs) {
    const double rival = figure_of(run, claim.rival, claim.measure);
    if (rival > 0) ratios.push_back(figure_of(run, claim.subject, claim.measure) / rival);
  }
  return ratios;
}

}  // namespace

std::span<const std::string_view> related_contestants() { return kRelated; }
std::span<const RelatedClaim> related_claims() { return kRelatedClaims; }

RelatedRun summarise(const ExperimentRun& run) {
  RelatedRun summary;
  const std::size_t contestants = run.empty() ? 0 : run.front().contestants.size();
  summary.parts.resize(contestants);
  summary.wrong.assign(contestants, 0);
  for (std::size_t k = 0; k < contestants; ++k) {
    std::array<std::size_t, kRelatedParts> steps{};
    std::array<std::size_t, kRelatedParts> counts{};
    for (std::size_t step = 0; step < run.size(); ++step) {
      const std::size_t part = step * kRelatedParts / run.size();
      const ContestantStep& of = run[step].contestants[k];
      RelatedFigures& figures = summary.parts[k][part];
      figures.update += of.update;
      figures.collision += of.collision;
      figures.candidates += std::max(0.0, of.candidates);
      steps[part] += 1;
      counts[part] += of.candidates < 0 ? 0 : 1;
      summary.wrong[k] += of.wrong;
    }
    for (std::size_t part = 0; part < kRelatedParts; ++part) {
      RelatedFigures& figures = summary.parts[k][part];
      figures.update /= static_cast<double>(std::max<std::size_t>(steps[part], 1));
      figures.collision /= static_cast<double>(std::max<std::size_t>(steps[part], 1));
      figures.candidates /= static_cast<double>(std::max<std::size_t>(counts[part], 1));
    }
  }
  return summary;
}

RelatedVerdict judge(const RelatedClaim& claim, const RelatedRuns& runs) {
  RelatedVerdict verdict;
  if (claim.measure == RelatedMeasure::none) return verdict;
  std::size_t hold = 0;
  std::size_t in_kind = 0;
  std::size_t judged = 0;
  for (const std::vector<RelatedRun>& simulation : runs) {
    const std::vector<double> ratios = ratios_of(claim, simulation);
    if (ratios.size() < kLeastSamples) continue;
    const auto holds = [&](double ratio) {
      return claim.more ? ratio > claim.factor : ratio < 1 / claim.factor;
    };
    const auto is_on_its_side = [&](double ratio) { return claim.more ? ratio > 1 : ratio < 1; };
    judged += ratios.size();
    hold += static_cast<std::size_t>(std::ranges::count_if(ratios, holds));
    in_kind += static_cast<std::size_t>(std::ranges::count_if(ratios, is_on_its_side));
    verdict.figures += (verdict.figures.empty() ? "" : ", ") + short_number(median(ratios));
  }
  if (judged == 0) return verdict;
  verdict.figures += " times";
  verdict.outcome = hold == judged ? Outcome::holds : in_kind > 0 ? Outcome::partly : Outcome::opposite;
  return verdict;
}

}  // namespace kerf
