#include "app/arguments.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "core/error.hpp"
#include "core/units.hpp"
#include "simulation/result/run_loop.hpp"

namespace tdbd::app {

namespace fs = std::filesystem;

void add_case(CLI::App& command, ResultArguments& a, const ResultHelp& help) {
  command.add_option("case", a.case_file, help.case_file)->required()->type_name(a_toml_file);
}

void add_set(CLI::App& command, std::vector<std::string>& overrides, const std::string& help) {
  command.add_option("--set", overrides, help)
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "number of threads; results do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

void add_result_options(CLI::App& command, ResultArguments& a, const ResultHelp& help) {
  command.add_option("-o,--output", a.folder, "result folder; default " + help.folder)
      ->type_name(a_folder);
  add_set(command, a.overrides,
          "override a key; may be repeated: " + help.set + "; `tdbd keys` lists the keys");
  command.add_flag("--force", a.force, "replace the results in the folder");
  command.add_flag("--quiet", a.quiet, help.quiet);
}

void add_resume(CLI::App& command, ResultArguments& a) {
  CLI::Option* resumed = command.add_option(
      "--resume", a.resumed, "resume the interrupted run in this folder (instead of a case)");
  resumed->type_name(a_folder);
  command.get_option("case")->required(false)->excludes(resumed);
  for (const char* other : {"--output", "--set", "--force"})
    command.get_option(other)->excludes(resumed);
}

int begin_or_resume(const ResultArguments& a, const std::function<int()>& begin,
                    const std::function<int()>& resume) {
  if (a.resumed.empty()) {
    if (a.case_file.empty())
      throw InputError("found no case, expected a case file, or --resume FOLDER");
    return begin();
  }
  if (!simulation::tidy_if_finished(a.resumed)) return resume();
  if (!a.quiet) print_out("{}: the run is complete, nothing to do\n", a.resumed);
  return 0;
}

fs::path result_folder(const ResultArguments& a, const std::string& suffix) {
  if (!a.folder.empty()) return a.folder;
  return fs::path("results") / (fs::path(a.case_file).stem().string() + suffix);
}

Overwrite overwrite_of(bool force) { return force ? Overwrite::force : Overwrite::no; }

void print_warning(const std::string& text) { fmt::print(stderr, "tdbd: warning: {}\n", text); }

void print_warnings(const std::vector<simulation::CaseWarning>& warnings) {
  for (const simulation::CaseWarning& w : warnings) print_warning(simulation::with_place(w));
}

double option_quantity(const std::string& option, const std::string& text,
                       const std::string& si_unit, const Range& range, const std::string& what) {
  try {
    if (const double value = to_si(text, si_unit); range.contains(value)) return value;
  } catch (const UnitError&) {  // reported below, with the expected value
  }
  throw InputError(fmt::format("{}: found '{}', expected {} {} with its unit", option, text, what,
                               range.text().substr(2)));
}

}  // namespace tdbd::app
