#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/terminal.hpp"
#include "core/config/key_table.hpp"
#include "io/output_folder.hpp"
#include "simulation/case/run_settings.hpp"

namespace CLI {

class App;
class ParseError;

}  // namespace CLI

namespace tdbd::app {

/// The list of commands with an example of each; printed by `tdbd` and `tdbd help`.
std::string overview(const CLI::App& app);

/// The output of `tdbd help --man` and `tdbd help --completion`: manual page and bash completion,
/// generated from the command definitions. Nothing for other words.
std::optional<std::string> requested_page(const CLI::App& app,
                                          const std::vector<std::string>& words);

/// Translates the words after the name of the program: `help` alone means the overview (empty
/// result), `help COMMAND` means `COMMAND --help`. Throws InputError with the closest command if
/// the first word is not a command.
std::vector<std::string> parsed_words(const CLI::App& app, std::vector<std::string> words);

/// The largest number of lines that a search for keys prints.
inline constexpr std::size_t most_search_lines = 60;

/// Searches tables of keys for words. A key is found if each word, without regard to case and to
/// the difference between "_", "-" and a blank, occurs in the name of the key, the name of its
/// table, its meaning or its allowed values. Returns the text for a terminal, at most
/// most_search_lines lines: first the keys that have all words in their name or that of their
/// table, then the others, then tables whose meaning alone has the words. Throws InputError with
/// the nearest words that occur if nothing is found.
std::string keys_about(std::span<const KeyTable> tables, const std::string& words);

/// Message for words that CLI11 rejected: found, expected.
std::string mistake(const CLI::ParseError& error);

}  // namespace tdbd::app

namespace CLI {

class App;

}  // namespace CLI

namespace tdbd::app {

/// Each function adds one subcommand, which stores its exit code in `exit_code`.
void add_run(CLI::App& app, int& exit_code);
void add_rotate(CLI::App& app, int& exit_code);
void add_string(CLI::App& app, int& exit_code);
void add_converge(CLI::App& app, int& exit_code);
void add_calibrate(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_keys(CLI::App& app, int& exit_code);
void add_bit(CLI::App& app, int& exit_code);
void add_laboratory(CLI::App& app, int& exit_code);
void add_new(CLI::App& app, int& exit_code);
void add_sweep(CLI::App& app, int& exit_code);
void add_curve(CLI::App& app, int& exit_code);
void add_mesh(CLI::App& app, int& exit_code);
void add_draw(CLI::App& app, int& exit_code);
void add_page(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);

/// Runs the body of a command and returns its exit code: 2 after an InputError or an invalid path,
/// 1 after any other failure, each with one message on standard error.
int guarded(const std::function<int()>& body);

/// Names of files and folders in the help. Shell completion derives from these and from {a,b,c}
/// which words to offer; FILE.a|b means one of these extensions.
inline constexpr const char* a_folder = "FOLDER";
inline constexpr const char* a_toml_file = "FILE.toml";
inline constexpr const char* a_mesh_file = "FILE.stl|obj|ply|off";

/// Arguments common to all commands that read a case and write a result folder.
struct ResultArguments {
  std::string case_file, folder;
  std::string resumed;  ///< folder of an interrupted run; replaces a case
  std::vector<std::string> overrides;
  bool force = false, quiet = false;
};

/// Help texts that differ between commands.
struct ResultHelp {
  std::string case_file;                          ///< for example "the case file (TOML)"
  std::string folder = "results/CASE";            ///< the default, as shown in the help
  std::string set = "--set time.step='2 ms'";     ///< an example
  std::string quiet = "no progress, no summary";  ///< what --quiet suppresses
};

/// Adds the case file, a required argument.
void add_case(CLI::App& command, ResultArguments& a, const ResultHelp& help);

/// Adds -o, --set, --force and --quiet.
void add_result_options(CLI::App& command, ResultArguments& a, const ResultHelp& help);

/// Adds --resume, which replaces the case and the options that belong to one; --set gives a resumed
/// run a later end. Call it after the functions that add these.
void add_resume(CLI::App& command, ResultArguments& a);

/// Calls begin() for a case or resume() for a folder, or does nothing if the folder has a complete
/// result and --set is not given. Both functions return the exit code.
int begin_or_resume(const ResultArguments& a, const std::function<int()>& begin,
                    const std::function<int()>& resume);

/// Adds --set or --threads, which are the same for all commands.
void add_set(CLI::App& command, std::vector<std::string>& overrides, const std::string& help);
void add_threads(CLI::App& command, int& threads);

/// The folder given, or results/CASE followed by `suffix`.
std::filesystem::path result_folder(const ResultArguments& a, const std::string& suffix = "");

/// Converts the flag --force.
Overwrite overwrite_of(bool force);

/// Prints a line on standard error: "tdbd: warning: TEXT".
void print_warning(const std::string& text);

/// Prints one line per warning: "tdbd: warning: FILE:LINE: KEY: TEXT".
void print_warnings(const std::vector<simulation::CaseWarning>& warnings);

/// RunOptions or RotateOptions with the members that their commands have in common: output folder,
/// whether to replace it, handling of Ctrl-C, and warnings on standard error.
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

/// The value of an option with a quantity, in `si_unit`. `what` names it in messages: "a length".
/// Throws InputError if the unit is missing or of another dimension, or if the value is out of
/// range.
double option_quantity(const std::string& option, const std::string& text,
                       const std::string& si_unit, const Range& range, const std::string& what);

}  // namespace tdbd::app
