#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/arguments.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/provenance.hpp"
#include "simulation/case/case_kind.hpp"

namespace tdbd::app {
namespace {

namespace fs = std::filesystem;

/// The Python that runs the scripts, unless the environment variable TDBD_PYTHON names another one.
constexpr const char* system_python = "/usr/bin/python3";
constexpr const char* python_variable = "TDBD_PYTHON";

std::string python_program() {
  const char* chosen = std::getenv(python_variable);
  return chosen != nullptr && *chosen != '\0' ? chosen : system_python;
}

/// The source directory of the build in `folder`, as its CMakeCache.txt records it. None if the
/// folder is not a build.
std::optional<fs::path> source_of_build(const fs::path& folder) {
  const std::string key = "CMAKE_HOME_DIRECTORY:INTERNAL=";
  std::ifstream cache(folder / "CMakeCache.txt");
  for (std::string line; std::getline(cache, line);)
    if (line.starts_with(key)) return line.substr(key.size());
  return {};
}

/// The directory of the scripts: share/tdbd/reports of an installation, or reports of the sources
/// that contain the build directory build/PRESET or from which the build was configured. Throws
/// InputError that lists the directories without `script`.
fs::path scripts_folder(const std::string& script) {
  const fs::path folder = fs::canonical(program_file()).parent_path(), above = folder.parent_path();
  std::vector<fs::path> tried{above / "share" / "tdbd" / "reports",
                              above.parent_path() / "reports"};
  if (const auto source = source_of_build(folder)) tried.push_back(*source / "reports");
  for (const fs::path& one : tried)
    if (fs::is_regular_file(one / script)) return one;
  std::string places;
  for (const fs::path& one : tried) places += (places.empty() ? "" : " or ") + one.string();
  throw InputError(
      fmt::format("found no script {}, expected it in {}: install TDBD with cmake --install, or "
                  "run the program "
                  "in its build directory",
                  script, places));
}

/// Replaces this process by Python with a script, so that its exit code and its reaction to Ctrl-C
/// are those of the command. Throws InputError if there is no such Python.
[[noreturn]] void run_script(const std::string& script, const std::vector<std::string>& arguments) {
  const std::string python = python_program();
  std::vector<std::string> words{python, "-B", (scripts_folder(script) / script).string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  execv(python.c_str(), pointers.data());
  throw InputError(fmt::format(
      "{}: found no Python that starts ({}), expected Python 3 with numpy, matplotlib, netCDF4, "
      "jinja2 and PIL (bash scripts/setup installs them); the environment variable {} names "
      "another "
      "Python",
      python, std::strerror(errno), python_variable));
}

/// Throws InputError if nothing exists at the path, before Python starts.
void require_existing(const std::string& path) {
  if (!fs::exists(path))
    throw InputError(
        fmt::format("{}: found nothing, expected a result folder or a table NAME.nc", path));
}

struct DrawArguments {
  std::vector<std::string> results;
  std::string output, gif;
  int most = 50;
};

/// The options that are not empty, as words for a script.
std::vector<std::string> option_words(
    const std::vector<std::pair<std::string, std::string>>& options) {
  std::vector<std::string> words;
  for (const auto& [name, value] : options)
    if (!value.empty()) words.insert(words.end(), {name, value});
  return words;
}

int draw_results(const DrawArguments& a) {
  for (const std::string& result : a.results) require_existing(result);
  std::vector<std::string> words = option_words({{"-o", a.output}, {"--gif", a.gif}});
  words.insert(words.end(), a.results.begin(), a.results.end());
  run_script("draw.py", words);
}

/// Runs a script that makes one page of one result folder.
int make_page(const std::string& script, const DrawArguments& a,
              const std::vector<std::string>& more = {}) {
  require_existing(a.results.front());
  std::vector<std::string> words = option_words({{"-o", a.output}});
  words.insert(words.end(), more.begin(), more.end());
  words.push_back(a.results.front());
  run_script(script, words);
}

/// Adds the result folder, the only positional argument of a command.
void add_result(CLI::App& command, DrawArguments& a, const std::string& help) {
  command.add_option("result", a.results, help)
      ->required()
      ->expected(1)
      ->allow_extra_args(false)
      ->type_name(a_folder);
}

}  // namespace

void add_draw(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("draw", "Draw a result as pictures (PNG, SVG)");
  auto a = std::make_shared<DrawArguments>();
  command
      ->add_option(
          "results", a->results,
          "a result folder of run, rotate, string, converge, calibrate or curve, or the table "
          "of a sweep (NAME.nc); several folders of rotate or converge: one work-precision "
          "diagram")
      ->required()
      ->type_name("FILE.nc");
  command
      ->add_option("-o,--output", a->output,
                   "folder of the pictures; default: the result folder, or that of the table")
      ->type_name(a_folder);
  command->add_option("--gif", a->gif, "also an animation of a run with output.frames_every")
      ->type_name("FILE.gif");
  command->footer(
      "Prints the name of each picture. reports/README.md describes them. The environment "
      "variable\n"
      "TDBD_PYTHON names the Python to use instead of /usr/bin/python3.\n"
      "Example: tdbd draw results/first");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return draw_results(*a); }); });
}

void add_page(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("page", "Make the 3-D page of a run: one HTML file");
  auto a = std::make_shared<DrawArguments>();
  add_result(*command, *a, "a result folder of run");
  command->add_option("-o,--output", a->output, "the page; default: FOLDER/result.html")
      ->type_name("FILE.html");
  command->add_option("--most", a->most, "frames at most, evenly spaced")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->footer(
      "The page shows the hole growing if the run has frames: --set output.frames_every=STEPS.\n"
      "Example: tdbd page results/first -o first.html");
  command->callback([a, &exit_code] {
    exit_code = guarded([&] {
      return make_page("page3d.py", *a, {"--most", std::to_string(a->most)});
    });
  });
}

void add_report(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("report", "Make a printable page of a result: numbers and pictures");
  auto a = std::make_shared<DrawArguments>();
  add_result(
      *command, *a,
      "a result folder of run, rotate, string, converge, calibrate, curve or bit --report, or the "
      "table of a sweep");
  command
      ->add_option("-o,--output", a->output,
                   "the page; default: FOLDER/report.html or NAME_report.html")
      ->type_name("FILE.html");
  command->footer(
      "One HTML file without links to other files: results, bit, forces, hole, traces, settings.\n"
      "Example: tdbd report results/first -o first.html");
  command->callback(
      [a, &exit_code] { exit_code = guarded([&] { return make_page("run_report.py", *a); }); });
}

namespace {

struct CompareArguments {
  std::string first, second, output = "comparison.html";
  std::string penetration = "5 mm", speed = "120 rpm", strength = "60 MPa";
};

/// Throws InputError unless the path is a result folder or the file of a bit.
void require_bit(const std::string& path) {
  if (fs::is_directory(path)) return;
  simulation::require_kind(path, {}, {simulation::CaseKind::bit});
}

int compare_bits(const CompareArguments& a) {
  const auto quantity = [](const char* option, const std::string& text, const char* unit,
                           const char* what) {
    return fmt::format("{}", option_quantity(option, text, unit, Range::positive(), what));
  };
  std::vector<std::string> words{"--penetration",
                                 quantity("--penetration", a.penetration, "m", "a length"),
                                 "--speed",
                                 quantity("--speed", a.speed, "rad/s", "a rotary speed"),
                                 "--strength",
                                 quantity("--strength", a.strength, "Pa", "a pressure"),
                                 "--program",
                                 fs::canonical(program_file()).string(),
                                 "-o",
                                 a.output};
  for (const std::string& bit : {a.first, a.second}) {
    require_bit(bit);
    words.push_back(bit);
  }
  run_script("compare_bits.py", words);
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "compare", "Compare two bits: one page with profiles, forces, work rates and differences");
  auto a = std::make_shared<CompareArguments>();
  command->add_option("first", a->first, "a bit file (TOML), or a result folder of run")
      ->required()
      ->type_name(a_toml_file);
  command->add_option("second", a->second, "another one of the same kind")
      ->required()
      ->type_name(a_toml_file);
  command->add_option("-o,--output", a->output, "the page")
      ->type_name("FILE.html")
      ->capture_default_str();
  command->add_option("--penetration", a->penetration, "advance per revolution of bit files")
      ->capture_default_str();
  command->add_option("--speed", a->speed, "rotary speed, for the work rates of bit files")
      ->capture_default_str();
  command
      ->add_option("--strength", a->strength, "strength of the rock, for the forces of bit files")
      ->capture_default_str();
  command->footer(
      "Of two bit files the forces are an estimate: cut areas in steady drilling times stresses "
      "in\n"
      "proportion to the strength. Of two result folders they are those of the runs.\n"
      "tdbd-compare compares models of one bit instead.\n"
      "Example: tdbd compare cases/bits/bit-a.toml cases/bits/bit-b.toml -o a-b.html");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return compare_bits(*a); }); });
}

}  // namespace tdbd::app
