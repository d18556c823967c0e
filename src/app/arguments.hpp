#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/interrupts.hpp"
#include "core/config/key.hpp"
#include "simulation/case/case_warning.hpp"
#include "simulation/result/output_folder.hpp"

namespace tdbd::app {

/// What files and folders are called in help. Completion knows by these, and by {a,b,c}, what may
/// stand there; FILE.a|b is one of these endings.
inline constexpr const char* a_folder = "FOLDER";
inline constexpr const char* a_toml_file = "FILE.toml";
inline constexpr const char* a_mesh_file = "FILE.stl|obj|ply|off";

/// What every command is given that reads a case and writes a result folder.
struct ResultArguments {
  std::string case_file, folder;
  std::string resumed;  ///< folder of a run that was stopped, in place of a case
  std::vector<std::string> overrides;
  bool force = false, quiet = false;
};

/// The help that differs from command to command.
struct ResultHelp {
  std::string case_file;                          ///< "the case file (TOML)"
  std::string folder = "results/CASE";            ///< the default, as help shows it
  std::string set = "--set time.step='2 ms'";     ///< an example
  std::string quiet = "no progress, no summary";  ///< what --quiet leaves out
};

/// Adds the case file, which the command requires.
void add_case(CLI::App& command, ResultArguments& a, const ResultHelp& help);

/// Adds -o, --set, --force and --quiet.
void add_result_options(CLI::App& command, ResultArguments& a, const ResultHelp& help);

/// Adds --resume, which stands in place of the case and of what goes with one. After the others.
void add_resume(CLI::App& command, ResultArguments& a);

/// Does what was asked for: begin() with a case, resume() with a folder, nothing where that holds a
/// complete result. Both return the exit code.
int begin_or_resume(const ResultArguments& a, const std::function<int()>& begin,
                    const std::function<int()>& resume);

/// Adds --set and --threads, as all commands have them.
void add_set(CLI::App& command, std::vector<std::string>& overrides, const std::string& help);
void add_threads(CLI::App& command, int& threads);

/// The folder that was given, or results/CASE followed by `suffix`.
std::filesystem::path result_folder(const ResultArguments& a, const std::string& suffix = "");

/// What --force means.
simulation::Overwrite overwrite_of(bool force);

/// A line on standard error: "tdbd: warning: TEXT".
void print_warning(const std::string& text);

/// One for each: "tdbd: warning: FILE:LINE: KEY: TEXT".
void print_warnings(const std::vector<simulation::CaseWarning>& warnings);

/// RunOptions or RotateOptions with what their commands have in common: the folder, whether to
/// replace it, what Ctrl-C does, and warnings on standard error.
template <class Options>
Options options_for(const ResultArguments& a) {
  Options options;
  options.folder = a.resumed.empty() ? result_folder(a) : std::filesystem::path(a.resumed);
  options.overwrite = overwrite_of(a.force);
  end_on_interrupt();
  options.interrupted = &interrupt_flag();
  options.started = save_on_interrupt;
  options.warn = print_warning;
  return options;
}

/// The quantity of an option, in `si_unit`; `what` names it in the message: "a length". Throws
/// InputError when it has no unit, another dimension, or a value out of the range.
double option_quantity(const std::string& option, const std::string& text,
                       const std::string& si_unit, const Range& range, const std::string& what);

}  // namespace tdbd::app
