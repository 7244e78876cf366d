#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "frames/commands/command.h"

namespace kerf {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

/// The options that a command shows.
std::vector<const CLI::Option*> shown_options(const CLI::App& command) {
  std::vector<const CLI::Option*> shown;
  for (const CLI::Option* option : options_of(command))
    if (option->nonpositional() && !option->get_group().empty()) shown.push_back(option);
  return shown;
}

/// The first line, for a shell between single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text.substr(0, text.find('\n')))
    out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// All ways to write an option: "-o --out".
std::string spellings(const CLI::Option& option) {
  std::string text;
  for (const std::string& name : option.get_snames()) text += " -" + name;
  for (const std::string& name : option.get_lnames()) text += " --" + name;
  return text;
}

std::string all_spellings(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : shown_options(command)) text += spellings(*option);
  return text;
}

std::string for_bash(const CLI::App& program) {
  const std::string& name = program.get_name();
  std::string names;
  std::string cases;
  for (const CLI::App* command : commands_of(program)) {
    names += " " + command->get_name();
    cases += "    " + command->get_name() + ") words='";
    cases += all_spellings(*command) + "' ;;\n";
  }
  return "_" + name + "() {\n  local words current=${COMP_WORDS[COMP_CWORD]}\n  case ${COMP_WORDS[1]} in\n" +
         cases + "  esac\n  if ((COMP_CWORD == 1)); then\n    words='" + names + all_spellings(program) +
         "'\n  elif [[ $current != -* ]]; then\n    words=\n  fi\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n}\ncomplete -o default -F _" +
         name + " " + name + "\n";
}

/// 'name:description', in which a colon of the name would need a backslash.
std::string described(const std::string& name, const std::string& description) {
  return " " + quoted(name + ":" + description);
}

std::string described_options(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : shown_options(command))
    if (!option->get_lnames().empty())
      text += described("--" + option->get_lnames().front(), option->get_description());
  return text;
}

std::string for_zsh(const CLI::App& program) {
  std::string names;
  std::string cases;
  for (const CLI::App* command : commands_of(program)) {
    names += described(command->get_name(), command->get_description());
    cases += "  " + command->get_name() + ") options=(" + described_options(*command) + ") ;;\n";
  }
  return "#compdef " + program.get_name() + "\nlocal -a commands options\ncommands=(" + names +
         ")\noptions=(" + described_options(program) + ")\ncase $words[2] in\n" + cases +
         "esac\nif [[ $words[CURRENT] == -* ]]; then\n  _describe -o option options\n"
         "elif ((CURRENT == 2)); then\n  _describe command commands\nelse\n  _files\nfi\n";
}

std::string fish_options(const CLI::App& command, const std::string& begin) {
  std::string text;
  for (const CLI::Option* option : shown_options(command)) {
    text += begin;
    for (const std::string& name : option->get_snames()) text += " -s " + name;
    for (const std::string& name : option->get_lnames()) text += " -l " + name;
    text += " -d " + quoted(option->get_description()) + "\n";
  }
  return text;
}

std::string for_fish(const CLI::App& program) {
  const std::string begin = "complete -c " + program.get_name() + " -n ";
  std::string text = fish_options(program, begin + "__fish_use_subcommand");
  for (const CLI::App* command : commands_of(program)) {
    text += begin + "__fish_use_subcommand -a " + command->get_name() + " -d " +
            quoted(command->get_description()) + "\n";
    text += fish_options(*command, begin + "'__fish_seen_subcommand_from " + command->get_name() + "'");
  }
  return text;
}

/// A script with which a shell completes commands and options of a program, and names of files elsewhere:
/// "bash", "zsh" or "fish". Throws std::logic_error for another shell.
std::string completion(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return for_bash(program);
  if (shell == "zsh") return for_zsh(program);
  if (shell == "fish") return for_fish(program);
  throw std::logic_error("no completion for the shell " + shell);
}

class CompletionCommand final : public Command {
 public:
  explicit CompletionCommand(CLI::App& program);
  void run() const override;

 private:
  std::string shell_;
};

CompletionCommand::CompletionCommand(CLI::App& program)
    : Command(program, "completion", "Print a script that completes commands and options in a shell") {
  command_->add_option("SHELL", shell_, "bash: source <(kerf completion bash); zsh; fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
}

void CompletionCommand::run() const {
  std::fputs(completion(*command_->get_parent(), shell_).c_str(), stdout);
}

}  // namespace

AnyCommand make_completion_command(CLI::App& program) { return std::make_unique<CompletionCommand>(program); }

}  // namespace kerf
