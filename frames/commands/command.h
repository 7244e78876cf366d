#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace kerf {

/// A subcommand of `kerf`, whose options are members that the command line fills.
class Command {
 public:
  Command(CLI::App& program, const std::string& name, const std::string& description)
      : command_(program.add_subcommand(name, description)) {}
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  [[nodiscard]] bool chosen() const { return command_->parsed(); }
  /// Prints what it finds. Throws UsageError, DoesNotHold, Interrupted on request, and std::runtime_error if
  /// something cannot be read or written.
  virtual void run() const = 0;

 protected:
  /// Adds an option, or an argument, that takes a value.
  template <class Value>
  CLI::Option* option(const char* name, Value& value, const char* meaning, const char* type) {
    return command_->add_option(name, value, meaning)->type_name(type);
  }
  /// One that says where the command writes to. The help shows such options in a group of their own, by which
  /// a test finds them all and holds each against the rules of Outputs.
  CLI::Option* output(const char* name, std::string& path, const char* meaning, const char* type = "FILE") {
    return option(name, path, meaning, type)->group("Outputs");
  }

  CLI::App* command_;
};

/// The options and arguments of a command, those of its option groups, too.
std::vector<const CLI::Option*> options_of(const CLI::App& command);

using AnyCommand = std::unique_ptr<Command>;
/// Each adds its subcommand to the program, which must outlive it.
AnyCommand make_scenes_command(CLI::App& program);
AnyCommand make_render_command(CLI::App& program);
AnyCommand make_collect_command(CLI::App& program);
AnyCommand make_film_command(CLI::App& program);
AnyCommand make_film_diff_command(CLI::App& program);
AnyCommand make_record_command(CLI::App& program);
AnyCommand make_import_command(CLI::App& program);
AnyCommand make_rerun_command(CLI::App& program);
AnyCommand make_verify_command(CLI::App& program);
AnyCommand make_debug_command(CLI::App& program);
AnyCommand make_step_command(CLI::App& program);
AnyCommand make_explain_command(CLI::App& program);
AnyCommand make_compare_command(CLI::App& program);
AnyCommand make_lint_command(CLI::App& program);
AnyCommand make_minimize_command(CLI::App& program);
AnyCommand make_export_command(CLI::App& program);
AnyCommand make_diff_command(CLI::App& program);
AnyCommand make_advise_command(CLI::App& program);
AnyCommand make_bench_command(CLI::App& program);
AnyCommand make_bench_frames_command(CLI::App& program);
AnyCommand make_experiment_command(CLI::App& program);
AnyCommand make_report_command(CLI::App& program);
AnyCommand make_study_command(CLI::App& program);
AnyCommand make_doctor_command(CLI::App& program);
AnyCommand make_man_command(CLI::App& program);
AnyCommand make_completion_command(CLI::App& program);

}  // namespace kerf
