#include "app/arguments.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "core/error.hpp"
#include "core/units.hpp"

namespace tdbd::app {

namespace fs = std::filesystem;

void add_case(CLI::App& command, ResultArguments& a, const ResultHelp& help) {
  command.add_option("case", a.case_file, help.case_file)->required();
}

void add_set(CLI::App& command, std::vector<std::string>& overrides, const std::string& help) {
  command.add_option("--set", overrides, help)->allow_extra_args(false);
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "threads of a run; the results do not depend on them")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

void add_result_options(CLI::App& command, ResultArguments& a, const ResultHelp& help) {
  command.add_option("-o,--output", a.folder, "result folder; default " + help.folder);
  add_set(command, a.overrides,
          "override a key, as often as needed: " + help.set + "; `tdbd keys` lists the keys");
  command.add_flag("--force", a.force, "replace the results in the folder");
  command.add_flag("--quiet", a.quiet, help.quiet);
}

fs::path result_folder(const ResultArguments& a, const std::string& suffix) {
  if (!a.folder.empty()) return a.folder;
  return fs::path("results") / (fs::path(a.case_file).stem().string() + suffix);
}

simulation::Overwrite overwrite_of(bool force) {
  return force ? simulation::Overwrite::force : simulation::Overwrite::no;
}

void print_warnings(const std::vector<simulation::CaseWarning>& warnings) {
  for (const simulation::CaseWarning& w : warnings)
    fmt::print(stderr, "tdbd: warning: {}\n", simulation::with_place(w));
}

double option_quantity(const std::string& option, const std::string& text,
                       const std::string& si_unit, const Range& range, const std::string& what) {
  try {
    if (const double value = to_si(text, si_unit); range.contains(value)) return value;
  } catch (const UnitError&) {  // told below, with what was expected
  }
  throw InputError(fmt::format("{}: found '{}', expected {} {} with its unit", option, text, what,
                               range.text().substr(2)));
}

}  // namespace tdbd::app
