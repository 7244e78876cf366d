#include "frames/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "frames/commands/advise_command.h"
#include "frames/commands/bench_command.h"
#include "frames/commands/bench_frames_command.h"
#include "frames/commands/collect_command.h"
#include "frames/commands/command_options.h"
#include "frames/commands/compare_command.h"
#include "frames/commands/completion_command.h"
#include "frames/commands/debug_command.h"
#include "frames/commands/diff_command.h"
#include "frames/commands/doctor_command.h"
#include "frames/commands/exit_codes.h"
#include "frames/commands/experiment_command.h"
#include "frames/commands/explain_command.h"
#include "frames/commands/export_command.h"
#include "frames/commands/film_command.h"
#include "frames/commands/film_diff_command.h"
#include "frames/commands/import_command.h"
#include "frames/commands/lint_command.h"
#include "frames/commands/man_command.h"
#include "frames/commands/memory_advice.h"
#include "frames/commands/minimize_command.h"
#include "frames/commands/record_command.h"
#include "frames/commands/render_command.h"
#include "frames/commands/report_command.h"
#include "frames/commands/rerun_command.h"
#include "frames/commands/scenes_command.h"
#include "frames/commands/step_command.h"
#include "frames/commands/study_command.h"
#include "frames/commands/verify_command.h"
#include "frames/support/disk_advice.h"
#include "frames/support/errors.h"
#include "frames/support/suggest.h"
#include "frames/support/version.h"

namespace kerf {
namespace {

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
template <class... Command>
int run(const CLI::App& program, const Command&... commands) {
  try {
    refuse_empty_arguments(chosen_command(program));
    ((commands.chosen() ? commands.run() : void()), ...);
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

int run_command_line(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grew too large is an error that can be reported
  CLI::App program("See, step through and measure a broad phase", "kerf");
  program.set_version_flag("--version", std::string("kerf ") + version());
  const ScenesCommand scenes(program);
  const RenderCommand render(program);
  const CollectCommand collector(program);
  const FilmCommand film(program);
  const FilmDiffCommand film_diff(program);
  const RecordCommand record(program);
  const ImportCommand import(program);
  const RerunCommand rerun(program);
  const VerifyCommand verify(program);
  const DebugCommand debug(program);
  const StepCommand step(program);
  const ExplainCommand explain(program);
  const CompareCommand compare(program);
  const LintCommand lint(program);
  const MinimizeCommand minimize(program);
  const ExportCommand exporter(program);
  const DiffCommand diff(program);
  const AdviseCommand advise(program);
  const BenchCommand bench(program);
  const BenchFramesCommand bench_frames(program);
  const ExperimentCommand experiment(program);
  const ReportCommand report_page(program);
  const StudyCommand study(program);
  const DoctorCommand doctor(program);
  const ManCommand man(program);
  const CompletionCommand completer(program);
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
  return run(program, scenes, render, collector, film, film_diff, record, import, rerun, verify, debug, step,
             explain, compare, lint, minimize, exporter, diff, advise, bench, bench_frames, experiment,
             report_page, study, doctor, man, completer);
}

}  // namespace kerf
