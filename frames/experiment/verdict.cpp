#include "frames/experiment/verdict.h"

#include <algorithm>
#include <array>
#include <limits>

#include "frames/experiment/simulation.h"
#include "frames/experiment/spread.h"
#include "frames/page/short_number.h"

namespace kerf {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// The ratios of which a relation speaks, and its direction: -1 less, 1 more, 0 neither.
struct Band {
  double low;
  double high;
  int direction;
  std::string_view words;
};

constexpr std::array<Band, 6> kBands{{{0, 1, -1, "less"},
                                      {0, 1 / kTolerance, -1, "much less"},
                                      {1 / kTolerance, 1, -1, "slightly less"},
                                      {1, kEndless, 1, "more"},
                                      {kTolerance, kEndless, 1, "much more"},
                                      {1 / kTolerance, kTolerance, 0, "similar"}}};

const Band& band_of(Relation relation) { return kBands[static_cast<std::size_t>(relation)]; }

/// What the figures say of one comparison.
struct Finding {
  Outcome outcome = Outcome::cannot_be_judged;
  int side = 0;  ///< of what the paper says: -1 below it, 1 above it
  std::string reason;
};

const std::vector<double>& samples_of(const Quantity& quantity, const ClaimFigures& figures) {
  static const std::vector<double> kNoSamples;
  const auto found = figures.find(quantity);
  return found == figures.end() ? kNoSamples : found->second;
}

double ratio(double a, double b) {
  if (b == 0) return a == 0 ? 1 : kEndless;
  return a / b;
}

/// Run by run; empty if the two have not the same runs.
std::vector<double> ratios(const Comparison& comparison, const ClaimFigures& figures) {
  std::vector<double> values = samples_of(comparison.subject, figures);
  if (!comparison.rival) {
    for (double& value : values) value = ratio(value, comparison.number);
    return values;
  }
  const std::vector<double>& others = samples_of(*comparison.rival, figures);
  if (others.size() != values.size()) return {};
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = ratio(values[k], others[k]);
  return values;
}

bool has_figure(const Quantity& quantity, const ClaimFigures& figures) {
  return spread_of(samples_of(quantity, figures)).has_value();
}

std::string name_in(const Quantity& quantity, const Comparison& comparison) {
  const bool several = comparison.rival && comparison.rival->simulation != comparison.subject.simulation;
  return std::string(paper_name(quantity.contestant)) +
         (several ? " in " + std::to_string(quantity.simulation) : "");
}

/// "SP is 0.31 (0.29 to 0.35) times BSP", or "BSP is 12 (11 to 14)" beside a number.
std::string sentence(const Comparison& comparison, const Spread& ratio) {
  const std::string subject = name_in(comparison.subject, comparison) + " is ";
  if (comparison.rival) return subject + text_of(ratio) + " times " + name_in(*comparison.rival, comparison);
  const double number = comparison.number;
  return subject + text_of({ratio.median * number, ratio.low * number, ratio.high * number, ratio.samples});
}

/// "much less", or "much less than 4" beside a number.
std::string words_of(const Comparison& comparison) {
  const std::string words(band_of(comparison.relation).words);
  return comparison.rival ? words : words + " than " + short_number(comparison.number);
}

bool are_alike(const Spread& ratio) { return ratio.low >= 1 / kAlike && ratio.high <= kAlike; }

/// Whether the ratio is on the side that a relation with a direction means.
Outcome outcome_by_direction(const Band& band, const Spread& spread) {
  if (are_alike(spread)) return Outcome::partly;
  const bool below = spread.high < 1;
  const bool above = spread.low > 1;
  if (band.direction < 0 ? above : below) return Outcome::opposite;
  if (!(band.direction < 0 ? below : above)) return Outcome::cannot_be_judged;
  return spread.low >= band.low && spread.high <= band.high ? Outcome::holds : Outcome::partly;
}

Outcome outcome_by_band(const Band& band, const Spread& spread) {
  if (spread.low >= band.low && spread.high <= band.high) return Outcome::holds;
  return spread.high < band.low || spread.low > band.high ? Outcome::opposite : Outcome::cannot_be_judged;
}

std::string reason_of(Outcome outcome, const Comparison& comparison, const Spread& spread) {
  const Band& band = band_of(comparison.relation);
  const std::string found = sentence(comparison, spread);
  if (outcome == Outcome::cannot_be_judged) return found + ", which leaves it open";
  if (outcome == Outcome::opposite) return found + ", not " + words_of(comparison);
  if (are_alike(spread)) return found + ", alike";
  const std::string kind = band.direction < 0 ? "less" : "more";
  if (comparison.relation != Relation::slightly_less)
    return found + ", " + kind + " and not surely much " + kind;
  return found + (spread.high < band.low ? ", much less, not slightly" : ", less and not surely slightly");
}

Finding examine(const Comparison& comparison, const ClaimFigures& figures) {
  Finding finding;
  for (const Quantity* quantity : {&comparison.subject, comparison.rival ? &*comparison.rival : nullptr})
    if (quantity != nullptr && !has_figure(*quantity, figures)) {
      finding.reason = "no figure of " + name_in(*quantity, comparison);
      return finding;
    }
  const auto spread = spread_of(ratios(comparison, figures));
  if (!spread || spread->samples < kLeastSamples) {
    finding.reason = spread
                         ? "too few runs: " + std::to_string(spread->samples) + ", and " +
                               std::to_string(kLeastSamples) + " make a spread"
                         : "the runs of " + name_in(comparison.subject, comparison) + " and its rival differ";
    return finding;
  }
  const Band& band = band_of(comparison.relation);
  finding.outcome =
      band.direction == 0 ? outcome_by_band(band, *spread) : outcome_by_direction(band, *spread);
  if (finding.outcome == Outcome::holds) return finding;
  finding.reason = reason_of(finding.outcome, comparison, *spread);
  if (finding.outcome != Outcome::cannot_be_judged)
    finding.side = spread->median <= band.low ? -1 : spread->median >= band.high ? 1 : 0;
  return finding;
}

/// Of the comparisons of a claim, each decided.
Outcome combine(std::size_t holding, std::size_t partly, const Claim& claim) {
  const std::size_t all = claim.comparisons.size();
  if (holding == all || (holding > 0 && claim.one_suffices)) return Outcome::holds;
  const std::size_t enough = claim.one_suffices ? 1 : (all + 1) / 2;
  return holding + partly >= enough ? Outcome::partly : Outcome::opposite;
}

/// What remains the same however the open ones would turn out.
Outcome combine(const std::vector<Finding>& findings, const Claim& claim) {
  const auto count = [&](Outcome outcome) {
    return static_cast<std::size_t>(std::ranges::count(findings, outcome, &Finding::outcome));
  };
  const std::size_t open = count(Outcome::cannot_be_judged);
  const Outcome best = combine(count(Outcome::holds) + open, count(Outcome::partly), claim);
  const Outcome worst = combine(count(Outcome::holds), count(Outcome::partly), claim);
  return best == worst ? best : Outcome::cannot_be_judged;
}

bool is_in(std::string_view name, const Comparison& comparison) {
  return paper_name(comparison.subject.contestant) == name ||
         (comparison.rival && paper_name(comparison.rival->contestant) == name);
}

/// 1 if ours fares better than the paper says, -1 if worse, 0 if as it says or unknown.
int gain_of(std::string_view ours, const Comparison& comparison, const Finding& finding) {
  const Merit merit = traits_of(comparison.subject.measure).merit;
  if (finding.side == 0 || merit == Merit::none || !is_in(ours, comparison)) return 0;
  const bool less_is_better = merit == Merit::less;
  const bool ours_is_subject = paper_name(comparison.subject.contestant) == ours;
  return (finding.side < 0) == less_is_better ? (ours_is_subject ? 1 : -1) : (ours_is_subject ? -1 : 1);
}

std::string_view ours_in(const Claim& claim) {
  for (const std::string_view name : {"BSP", "LO", "SP"})
    if (std::ranges::any_of(claim.comparisons, [&](const Comparison& c) { return is_in(name, c); }))
      return name;
  return {};
}

Standing standing_of(std::string_view ours, const Claim& claim, const std::vector<Finding>& findings) {
  bool better = false;
  bool worse = false;
  bool decided = false;
  for (std::size_t k = 0; k < findings.size(); ++k) {
    if (!is_in(ours, claim.comparisons[k])) continue;
    const int gain = gain_of(ours, claim.comparisons[k], findings[k]);
    better |= gain > 0;
    worse |= gain < 0;
    decided |= findings[k].outcome != Outcome::cannot_be_judged &&
               traits_of(claim.comparisons[k].subject.measure).merit != Merit::none;
  }
  if (better && worse) return Standing::mixed;
  if (better || worse) return better ? Standing::better : Standing::worse;
  return decided ? Standing::as_the_paper : Standing::unknown;
}

/// Each quantity once, with its spread: "BSP 0.5 (0.4 to 0.6), QT 0.7 ms".
std::string figures_of(const Claim& claim, const ClaimFigures& figures) {
  std::vector<Quantity> quantities;
  for (const Comparison& comparison : claim.comparisons)
    for (const Quantity* quantity : {&comparison.subject, comparison.rival ? &*comparison.rival : nullptr})
      if (quantity != nullptr && std::ranges::find(quantities, *quantity) == quantities.end())
        quantities.push_back(*quantity);
  std::ranges::stable_sort(quantities, {},
                           [](const Quantity& q) { return std::pair(q.measure, q.simulation); });
  const bool several = std::ranges::any_of(
      quantities, [&](const Quantity& q) { return q.simulation != quantities.front().simulation; });
  std::string text;
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const Quantity& quantity = quantities[k];
    const bool begins = k == 0 || quantities[k - 1].measure != quantity.measure;
    if (begins) text += (k == 0 ? "" : "; ") + std::string(traits_of(quantity.measure).name) + ": ";
    const auto spread = spread_of(samples_of(quantity, figures));
    text += (begins ? "" : ", ") + std::string(paper_name(quantity.contestant)) +
            (several ? " in " + std::to_string(quantity.simulation) : "") + " " +
            (spread ? text_of(*spread) : "-");
    if (k + 1 == quantities.size() || quantities[k + 1].measure != quantity.measure)
      text += traits_of(quantity.measure).unit;
  }
  return text;
}

}  // namespace

std::string_view name_of(Outcome outcome) {
  constexpr std::array<std::string_view, 4> kNames{"holds", "partly", "opposite", "cannot be judged"};
  return kNames[static_cast<std::size_t>(outcome)];
}

std::string text_of_standing(const ClaimVerdict& verdict) {
  constexpr std::array<const char*, 4> kWords{"as the paper", "better for ", "worse for ", "mixed for "};
  if (verdict.standing == Standing::unknown || verdict.ours.empty()) return "";
  const std::string words = kWords[static_cast<std::size_t>(verdict.standing)];
  return verdict.standing == Standing::as_the_paper ? words : words + std::string(verdict.ours);
}

ClaimVerdict judge(const Claim& claim, const ClaimFigures& figures) {
  ClaimVerdict verdict;
  if (claim.comparisons.empty()) {
    verdict.reason = claim.note;
    return verdict;
  }
  std::vector<Finding> findings;
  for (const Comparison& comparison : claim.comparisons) findings.push_back(examine(comparison, figures));
  verdict.outcome = combine(findings, claim);
  verdict.ours = ours_in(claim);
  if (verdict.outcome != Outcome::cannot_be_judged)
    verdict.standing = standing_of(verdict.ours, claim, findings);
  verdict.figures = figures_of(claim, figures);
  for (const Finding& finding : findings)
    if (!finding.reason.empty() && verdict.reason.find(finding.reason) == std::string::npos)
      verdict.reason += (verdict.reason.empty() ? "" : "; ") + finding.reason;
  return verdict;
}

}  // namespace kerf
