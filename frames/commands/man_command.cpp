#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sstream>
#include <string>

#include "frames/commands/command.h"
#include "frames/support/version.h"

namespace kerf {
namespace {

/// Text for roff: a backslash, a dash and a dot that begins a line are commands otherwise.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

/// Each line of the text on a line of its own, as in the help.
std::string lines(const std::string& text) {
  std::istringstream in(escaped(text));
  std::string out;
  for (std::string line; std::getline(in, line);) out += line + "\n.br\n";
  return out;
}

std::string option_text(const CLI::Option& option, bool positional) {
  const CLI::Formatter formatter;
  return ".TP\n\\fB" + escaped(formatter.make_option_name(&option, positional)) + "\\fR" +
         escaped(formatter.make_option_opts(&option)) + "\n" + escaped(formatter.make_option_desc(&option)) +
         "\n";
}

std::string command_text(const CLI::App& program, const CLI::App& command) {
  std::string usage;
  std::string text;
  std::string options;
  for (const CLI::Option* option : options_of(command)) {
    if (option->get_positional()) {
      usage += " " + CLI::Formatter().make_option_usage(option);
      text += option_text(*option, true);
    } else if (option->nonpositional() && !option->get_group().empty()) {
      options += option_text(*option, false);
    }
  }
  return ".SS " + escaped(program.get_name() + " " + command.get_name() + usage) + "\n" +
         escaped(command.get_description()) + "\n" + text + options + ".PP\n" + lines(command.get_footer());
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// The man page of a program, section 1, in roff, from what its `--help` says.
std::string manual(const CLI::App& program) {
  const std::string& name = program.get_name();
  std::string text = ".TH " + upper(name) + " 1 \"\" \"" + name + " " + version() + "\"\n.SH NAME\n" + name +
                     " \\- " + escaped(program.get_description()) + "\n.SH SYNOPSIS\n.B " + name +
                     "\n.I command\n[options]\n.SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    text += command_text(program, *command);
  return text +
         ".SH SEE ALSO\nThe pages that the commands name, such as docs/DEBUGGING.md, are in the repository. "
         "Debian's package kerf\\-doc has them in /usr/share/doc/kerf\\-doc.\n";
}

class ManCommand final : public Command {
 public:
  explicit ManCommand(CLI::App& program);
  void run() const override;
};

ManCommand::ManCommand(CLI::App& program)
    : Command(program, "man", "Print the man page: kerf man | man --local-file -") {}

void ManCommand::run() const { std::fputs(manual(*command_->get_parent()).c_str(), stdout); }

}  // namespace

AnyCommand make_man_command(CLI::App& program) { return std::make_unique<ManCommand>(program); }

}  // namespace kerf
