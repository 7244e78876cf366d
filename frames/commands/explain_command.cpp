#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "core/query/explain_event.h"
#include "core/query/explain_node.h"
#include "core/query/explain_pair.h"
#include "core/query/explain_query.h"
#include "core/query/explain_their_search.h"
#include "frames/commands/command.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

std::uint32_t parse_id(const std::string& option, const std::string& text, const std::string& prefix) {
  const std::size_t skip = text.starts_with(prefix) ? prefix.size() : 0;
  const auto id = parse_number<std::uint32_t>(std::string_view(text).substr(skip));
  if (!id)
    throw UsageError(option + " '" + text + "' is no number such as 17" +
                     (prefix.empty() ? "" : " or " + prefix + "17"));
  return *id;
}

ObjectId find_object(const std::string& option, std::string_view text, const GivenNames& names) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  const auto id = parse_given_id(text);
  if (!id) throw UsageError(option + ": '" + std::string(text) + "' is no whole number such as 17");
  const auto object = names.find_object(*id);
  if (!object) throw UsageError(option + ": the recording has no object " + to_string(*id));
  return *object;
}

Pair parse_pair(const std::string& text, const GivenNames& names) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw UsageError("--pair '" + text + "' is not of the form I,J, for example 12,77");
  const ObjectId a = find_object("--pair", std::string_view(text).substr(0, comma), names);
  const ObjectId b = find_object("--pair", std::string_view(text).substr(comma + 1), names);
  if (a == b) throw UsageError("--pair '" + text + "': an object makes no pair with itself");
  return make_pair(a, b);
}

template <int D>
AskedQuery<D> parse_asked(const std::string& option, QueryKind kind, const std::string& numbers) {
  try {
    return parse_query<D>(kind, numbers);
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + error.what());
  }
}

struct Asked {
  QueryKind kind;
  const char* option;
  const char* meaning;
  const char* form;
};
constexpr std::array kAsked{
    Asked{QueryKind::ray, "--ray",
          "What a ray from a point along a direction hits, and which nodes it visits",
          "OX,OY,[OZ,]DX,DY[,DZ]"},
    Asked{QueryKind::box, "--box", "What a box overlaps, by its lower and its upper corner",
          "X,Y,[Z,]X,Y[,Z]"},
    Asked{QueryKind::sphere, "--sphere", "What a sphere overlaps; with the radius 0, a point",
          "X,Y,[Z,]RADIUS"},
    Asked{QueryKind::nearest, "--nearest", "The objects nearest to a point", "X,Y,[Z,]COUNT"}};

/// What cannot be asked has no answer.
template <int D>
std::string what_is_found(Replayer<D>& replayer, std::uint32_t step, const Asked& asked,
                          const std::string& numbers) {
  const AskedQuery<D> query = parse_asked<D>(asked.option, asked.kind, numbers);
  const QueryExplanation<D> explanation = explain_query(replayer, step, query);
  if (explanation.status != QueryStatus::ok)
    throw UsageError(std::string(asked.option) + " '" + numbers + "' cannot be asked, it is " +
                     std::string(to_string(explanation.status)) +
                     ": a box has its lower corner first, and a sphere no radius below 0");
  return to_text(explanation, replayer.recording().info().names);
}

/// In our tree, and in another engine's structure if that is known.
template <int D>
std::string why_pair(Replayer<D>& replayer, std::uint32_t step, const Pair& pair) {
  const RecordingInfo& info = replayer.recording().info();
  std::string text = to_text(explain_pair(replayer, step, pair), info);
  replayer.seek(step);
  if (const auto theirs = replayer.recording().their_structure(step))
    text += explain_their_search<D>(*theirs, replayer.tree().objects(), pair, info.names);
  return text;
}

class ExplainCommand final : public Command {
 public:
  explicit ExplainCommand(CLI::App& program);
  void run() const override;

 private:
  std::string file_;
  std::string step_;
  std::string pair_;
  std::string node_;
  std::string event_;
  std::array<std::string, 4> asked_;  ///< by kind of query
};

ExplainCommand::ExplainCommand(CLI::App& program)
    : Command(program, "explain",
              "Say why: a pair or none, a node, an event of a recording, what a query finds") {
  option("FILE", file_, "A recording", "")->required();
  option("--step", step_, "After which step (default: the last)", "N");
  auto* const subject = command_->add_option_group("subject");
  subject->add_option("--pair", pair_, "Why two objects are a pair, or why not")->type_name("I,J");
  subject->add_option("--node", node_, "What a node is and what happened to it")->type_name("K");
  subject->add_option("--event", event_, "Why an event happened")->type_name("E");
  for (const Asked& asked : kAsked)
    subject->add_option(asked.option, asked_[static_cast<std::size_t>(asked.kind)], asked.meaning)
        ->type_name(asked.form);
  subject->require_option(1);
}

void ExplainCommand::run() const {
  if (!event_.empty() && !step_.empty())
    throw UsageError("--step: an event is explained at its own step; leave --step or --event out");
  const std::string text =
      with_recording(file_, [&]<int D>(const std::shared_ptr<RecordingReader<D>>& recording) {
        Replayer<D> replayer(recording);
        const GivenNames& names = recording->info().names;
        if (!event_.empty()) {
          const auto position =
              parse_position("--event", event_.starts_with("e") ? event_ : "e" + event_, *recording);
          return to_text(explain_event(replayer, position.event), names);
        }
        const auto position = step_.empty() ? Position::end_of(recording->steps())
                                            : parse_position("--step", step_, *recording);
        if (!position.is_end()) throw UsageError("--step '" + step_ + "' is no step");
        if (!pair_.empty()) return why_pair(replayer, position.step, parse_pair(pair_, names));
        for (const Asked& asked : kAsked)
          if (command_->count(asked.option) > 0)
            return what_is_found(replayer, position.step, asked,
                                 asked_[static_cast<std::size_t>(asked.kind)]);
        return to_text(explain_node(replayer, position.step, NodeId{parse_id("--node", node_, "n")}), names);
      });
  std::fputs(text.c_str(), stdout);
}

}  // namespace

AnyCommand make_explain_command(CLI::App& program) { return std::make_unique<ExplainCommand>(program); }

}  // namespace kerf
