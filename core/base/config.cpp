#include "core/base/config.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "core/base/assignments.h"
#include "core/base/float_mode.h"
#include "core/base/number_text.h"

namespace kerf {
namespace {

using Member =
    std::variant<bool Config::*, float Config::*, std::uint32_t Config::*, std::uint64_t Config::*>;

struct Parameter {
  ConfigField field;
  Member member;
};

constexpr double kAny = 1e9;

const std::array kParameters{
    Parameter{
        {"candidate_factor", "candidates tried at a split: factor * sqrt(objects of the leaf)", 0, 1000},
        &Config::candidate_factor},
    Parameter{{"sample", "objects projected and sorted for each candidate", 2, kAny}, &Config::sample},
    Parameter{{"free_directions", "0: partitioners along the axes only", 0, 1}, &Config::free_directions},
    Parameter{{"min_balance", "below it a node is unbalanced", 0, 1}, &Config::min_balance},
    Parameter{{"max_redundancy", "straddlers of a partitioner over its population", 0, 1},
              &Config::max_redundancy},
    Parameter{{"scene_redundancy", "1: max_redundancy is a share of the scene's objects", 0, 1},
              &Config::scene_redundancy},
    Parameter{{"repair_redundancy", "above it a node is repaired like an unbalanced one", 0, 1},
              &Config::repair_redundancy},
    Parameter{{"min_threshold", "smallest split threshold", 1, kAny}, &Config::min_threshold},
    Parameter{{"max_threshold", "largest split threshold", 1, kAny}, &Config::max_threshold},
    Parameter{{"merge_fraction", "nodes below this share of the threshold are merged", 0, 1},
              &Config::merge_fraction},
    Parameter{{"event_capacity", "largest size of the event list", 0, kAny}, &Config::event_capacity},
    Parameter{{"budget_divisor", "events a step: list size / divisor; 0: no operators", 0, kAny},
              &Config::budget_divisor},
    Parameter{{"schedule_interval", "steps between two traversals", 1, 1e6}, &Config::schedule_interval},
    Parameter{{"split", "0: no leaf is ever divided", 0, 1}, &Config::split},
    Parameter{{"shift_split", "0: a crowded leaf is split by a new direction at once", 0, 1},
              &Config::shift_split},
    Parameter{{"merge", "0: only entries beyond their cap are merged away", 0, 1}, &Config::merge},
    Parameter{{"balance", "0: an unbalanced node is swapped at once", 0, 1}, &Config::balance},
    Parameter{{"swap", "0: a node that cannot be balanced stays as it is", 0, 1}, &Config::swap},
    Parameter{{"swap_share", "objects that a swap may insert into the heavier subtree, over its own", 0, 1},
              &Config::swap_share},
    Parameter{
        {"swap_rest", "scheduling intervals in which a leaf that a swap moved up is not split", 0, 1000},
        &Config::swap_rest},
    Parameter{{"max_height", "no split at or below this depth", 0, 63}, &Config::max_height},
    Parameter{
        {"max_entries",
         "no split once entries exceed this many times the objects; merges beyond twice as many", 1, 1000},
        &Config::max_entries},
    Parameter{{"directions", "size of the direction set in 3D; a quarter of it in 2D", 3, 4096},
              &Config::directions},
    Parameter{{"seed", "of the direction set", 0, 18446744073709551615.0}, &Config::seed},
    Parameter{{"byte_sweep", "1: leaves are swept by vectors of bytes", 0, 1}, &Config::byte_sweep},
    Parameter{{"skin", "steps of its motion that an object's fat box allows for; 0: none", 0, 1000},
              &Config::skin},
    Parameter{
        {"stream_share",
         "share of moving objects above which all are placed in one pass (if pairs are kept: 4 times)", 0, 1},
        &Config::stream_share},
    Parameter{{"bulk_factor", "leaves above so many thresholds are divided at once; 0: never", 0, 1e6},
              &Config::bulk_factor},
    Parameter{{"restless", "0: objects too fast for a fat box are placed anew in each step", 0, 1},
              &Config::restless},
    Parameter{{"resting_pairs", "0: pairs of objects at rest are tested in each step, too", 0, 1},
              &Config::resting_pairs},
    Parameter{{"leaf_boxes", "0: leaves have no copies of their boxes in large worlds", 0, 1},
              &Config::leaf_boxes},
    Parameter{{"rows", "0: small worlds have no rows of bits for their pairs", 0, 1}, &Config::rows},
    Parameter{{"dense", "0: floats confirm all that bytes find", 0, 1}, &Config::dense},
};

const Parameter& find(std::string_view name) {
  for (const Parameter& parameter : kParameters)
    if (parameter.field.name == name) return parameter;
  std::string message = "unknown parameter '" + std::string(name) + "'; known are";
  for (const Parameter& parameter : kParameters) message += " " + std::string(parameter.field.name);
  throw std::invalid_argument(message);
}

std::string whole_number(double x) {
  if (x >= static_cast<double>(UINT64_MAX)) return std::to_string(UINT64_MAX);  // the double is one more
  return std::to_string(static_cast<std::uint64_t>(x));
}

/// `Value`: the type of the parameter.
template <class Value>
[[noreturn]] void reject(const ConfigField& field, std::string_view text) {
  std::string expected =
      " is not a number from " + exact_number(field.minimum) + " to " + exact_number(field.maximum);
  if constexpr (std::is_same_v<Value, bool>)
    expected = " is neither 0 nor 1";
  else if constexpr (std::is_integral_v<Value>)
    expected =
        " is not a whole number from " + whole_number(field.minimum) + " to " + whole_number(field.maximum);
  throw std::invalid_argument("parameter " + std::string(field.name) + ": '" + std::string(text) + "'" +
                              expected);
}

/// A number that is 0 as a float, though it is none.
bool vanishes(std::string_view text) {
  const double value = read_number<double>(text).value_or(0);
  return value != 0 && std::abs(value) < static_cast<double>(std::numeric_limits<float>::min());
}

template <class T>
T parse(const ConfigField& field, std::string_view text) {
  const DefaultFloats floats;  // std::from_chars may round as the caller does
  const auto value = read_number<T>(text);
  if (std::is_same_v<T, float> && value.value_or(0) == 0 && vanishes(text))
    throw std::invalid_argument("parameter " + std::string(field.name) + ": '" + std::string(text) +
                                "' is too small for a float; 0 is the nearest");
  if (!value) reject<T>(field, text);
  return *value;
}

bool parse_bool(const ConfigField& field, std::string_view text) {
  if (text == "1" || text == "true") return true;
  if (text == "0" || text == "false") return false;
  reject<bool>(field, text);
}

std::string value_text(const Config& config, const Parameter& parameter) {
  return std::visit(
      [&](auto member) -> std::string {
        if constexpr (std::is_same_v<decltype(member), bool Config::*>)
          return config.*member ? "1" : "0";
        else
          return exact_number(config.*member);
      },
      parameter.member);
}

void check(const Config& config, const Parameter& parameter) {
  std::visit(
      [&](auto member) {
        const auto value = static_cast<double>(config.*member);
        if (!(value >= parameter.field.minimum && value <= parameter.field.maximum))
          reject<std::remove_cvref_t<decltype(config.*member)>>(parameter.field,
                                                                value_text(config, parameter));
      },
      parameter.member);
}

}  // namespace

std::span<const ConfigField> config_fields() {
  static const auto kFields = [] {
    std::array<ConfigField, kParameters.size()> fields;
    for (std::size_t i = 0; i < fields.size(); ++i) fields[i] = kParameters[i].field;
    return fields;
  }();
  return kFields;
}

Config tuned_config() {
  Config config;
  config.free_directions = false;
  config.sample = 256;
  config.min_balance = 0.33F;
  config.max_redundancy = 0.35F;
  config.repair_redundancy = 0.6F;
  config.swap_share = 1;
  config.min_threshold = 1024;
  config.max_threshold = 1024;
  config.event_capacity = 16;
  config.budget_divisor = 4;
  config.byte_sweep = true;
  config.skin = 8;
  config.stream_share = 0.06F;
  config.bulk_factor = 2;
  return config;
}

void check(const Config& config) {
  for (const Parameter& parameter : kParameters) check(config, parameter);
  if (config.min_threshold > config.max_threshold)
    throw std::invalid_argument("parameter min_threshold: it must not exceed max_threshold");
}

std::string get(const Config& config, std::string_view name) { return value_text(config, find(name)); }

void set(Config& config, std::string_view name, std::string_view value) {
  const Parameter& parameter = find(name);
  Config changed = config;
  std::visit(
      [&](auto member) {
        using Value = std::remove_reference_t<decltype(changed.*member)>;
        if constexpr (std::is_same_v<Value, bool>)
          changed.*member = parse_bool(parameter.field, value);
        else
          changed.*member = parse<Value>(parameter.field, value);
      },
      parameter.member);
  check(changed, parameter);
  config = changed;
}

void apply(Config& config, std::string_view assignments) {
  Config changed = config;
  for (const auto& [name, value] : parse_assignments(assignments)) set(changed, name, value);
  check(changed);
  config = changed;
}

std::string to_string(const Config& config) {
  std::string text;
  for (const Parameter& parameter : kParameters) {
    if (!text.empty()) text += ',';
    text += std::string(parameter.field.name) + "=" + value_text(config, parameter);
  }
  return text;
}

}  // namespace kerf
