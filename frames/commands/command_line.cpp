#include "frames/commands/command_line.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "frames/commands/command.h"
#include "frames/commands/exit_codes.h"
#include "frames/commands/memory_advice.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/suggest.h"
#include "frames/support/version.h"

namespace kerf {
namespace {

/// In the order of the help.
constexpr std::array kCommands{
    make_scenes_command,     make_render_command,    make_collect_command,  make_film_command,
    make_film_diff_command,  make_record_command,    make_import_command,   make_rerun_command,
    make_verify_command,     make_debug_command,     make_step_command,     make_explain_command,
    make_compare_command,    make_lint_command,      make_minimize_command, make_export_command,
    make_diff_command,       make_advise_command,    make_bench_command,    make_bench_frames_command,
    make_experiment_command, make_report_command,    make_study_command,    make_doctor_command,
    make_man_command,        make_completion_command};

int report(const std::string& message, int exit_code) {
  std::fprintf(stderr, "kerf: %s\n", message.c_str());
  return exit_code;
}

const CLI::App& chosen_command(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? program : *chosen.front();
}

/// The long names of a command's options, or the program's subcommands.
std::vector<std::string> valid_names(const CLI::App& command, bool options) {
  std::vector<std::string> names;
  if (!options) {
    for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; })) {
      names.push_back(sub->get_name());
    }
    return names;
  }
  for (const CLI::Option* option : options_of(command)) {
    if (!option->nonpositional()) continue;
    names.push_back("--" + option->get_lnames().front());
  }
  return names;
}

void say_exit_codes(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) {
    const std::string footer = command->get_footer();
    command->footer(footer + (footer.empty() ? "" : "\n") + exit_help(command->get_name()));
  }
}

/// CLI11 only says that something was not expected; this suggests what was probably meant.
std::string unexpected_argument(const CLI::App& program) {
  const CLI::App& command = chosen_command(program);
  const std::vector<std::string> extras = program.remaining(true);
  std::string given = extras.empty() ? "" : extras.front();
  const bool is_option = given.starts_with("-");
  given = given.substr(0, given.find('='));
  if (is_option) return unknown_name_message("option", given, valid_names(command, true));
  if (&command == &program) return unknown_name_message("command", given, valid_names(program, false));
  return "'" + given + "' is one argument too many";
}

/// A file whose name begins with a dash is taken for an option.
std::string dash_hint(const CLI::App& program) {
  std::error_code none;
  for (const std::string& given : program.remaining(true))
    if (given.starts_with("-") && std::filesystem::exists(given, none))
      return "; '" + given + "' was taken for an option: write ./" + given;
  return "";
}

std::string help_hint(const CLI::App& program) {
  const CLI::App& command = chosen_command(program);
  return "\nTry `" + (&command == &program ? "" : program.get_name() + " ") + command.get_name() +
         " --help`.";
}

/// An empty text asks for nothing: most likely a variable of a script was not set.
void refuse_empty_arguments(const CLI::App& command) {
  for (const CLI::Option* const option : options_of(command)) {
    if (std::ranges::count(option->results(), std::string()) == 0) continue;
    if (option->nonpositional())
      throw UsageError("--" + option->get_lnames().front() + " is empty; give it " + option->get_type_name() +
                       ", or leave it out");
    throw UsageError(option->get_name(true) + " is empty; name one" +
                     (option->get_required() ? "" : ", or leave it out"));
  }
}

/// An exit code. Printed text may still lie in memory, and a full disk shows only when it is flushed.
int finish_output() {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return kExitHolds;
  return report("cannot write standard output: what was printed is not whole", kExitUnusable);
}

/// What was printed may be the answer: if it is lost, the exit code is that of no answer.
int report_after_output(const std::string& message, int exit_code) {
  const int written = finish_output();
  return report(message, written == kExitHolds ? exit_code : written);
}

/// Runs the chosen subcommand and turns its exception into an exit code.
int run(const CLI::App& program, const std::vector<std::unique_ptr<Command>>& commands) {
  try {
    refuse_empty_arguments(chosen_command(program));
    for (const auto& command : commands)
      if (command->chosen()) command->run();
    return finish_output();
  } catch (const DoesNotHold& error) {
    return report_after_output(error.what(), kExitDoesNotHold);
  } catch (const UsageError& error) {
    return report(error.what() + help_hint(program), kExitUnusable);
  } catch (const Interrupted& error) {
    return report_after_output(error.what(), kExitInterrupted);
  } catch (const std::bad_alloc&) {
    return report(out_of_memory(chosen_command(program).get_name()), kExitUnusable);
  } catch (const std::filesystem::filesystem_error& error) {
    return report(with_disk_advice(error.path1().string() + ": " + error.code().message()), kExitUnusable);
  } catch (const std::exception& error) {
    return report(with_disk_advice(error.what()), kExitUnusable);
  }
}

}  // namespace

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> options = command.get_options();
  // CLI11 keeps a group as a command without a name.
  for (const CLI::App* group : command.get_subcommands([](const CLI::App*) { return true; })) {
    if (!group->get_name().empty()) continue;
    const std::vector<const CLI::Option*> more = options_of(*group);
    options.insert(options.end(), more.begin(), more.end());
  }
  return options;
}

int run_command_line(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grew too large is an error that can be reported
  exit_when_interrupted(kExitInterrupted);
  CLI::App program("See, step through and measure a broad phase", "kerf");
  program.set_version_flag("--version", std::string("kerf ") + version());
  std::vector<std::unique_ptr<Command>> commands;
  for (const auto make : kCommands) commands.push_back(make(program));
  say_exit_codes(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    program.exit(help);
    return finish_output();
  } catch (const CLI::ExtrasError&) {
    return report(unexpected_argument(program) + dash_hint(program) + help_hint(program), kExitUnusable);
  } catch (const CLI::ParseError& error) {
    return report(error.what() + dash_hint(program) + help_hint(program), kExitUnusable);
  }
  if (program.get_subcommands().empty()) {
    std::fputs(program.help().c_str(), stderr);
    return kExitUnusable;
  }
  return run(program, commands);
}

}  // namespace kerf
