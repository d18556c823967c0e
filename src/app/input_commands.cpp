#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/arguments.hpp"
#include "app/templates.hpp"
#include "app/terminal.hpp"
#include "bit/cutter/cutter_columns.hpp"
#include "calibration/case/calibration_case.hpp"
#include "calibration/laboratory/laboratory.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "io/whole_file.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/chain/chain_run.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_simulation.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/step/simulation.hpp"
#include "sweep/design/design.hpp"

namespace tdbd::app {
namespace {

using simulation::counted;

namespace fs = std::filesystem;

struct NewArguments {
  std::string kind, folder;
};

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const TemplateFile& f : template_files())
    if (names.empty() || names.back() != f.kind) names.emplace_back(f.kind);
  return names;
}

std::vector<TemplateFile> files_of(const std::string& kind) {
  std::vector<TemplateFile> files;
  std::ranges::copy_if(template_files(), std::back_inserter(files),
                       [&](const TemplateFile& f) { return f.kind == kind; });
  if (!files.empty()) return files;
  const auto meant = nearest_name(kind, kinds());
  throw InputError(
      fmt::format("KIND: found {}, expected {}", kind,
                  meant ? *meant : fmt::format("one of {}", fmt::join(kinds(), ", "))));
}

/// Checks that the folder is new or empty, so that no existing file is changed.
void require_new(const fs::path& folder) {
  if (fs::exists(fs::symlink_status(folder)) && !(fs::is_directory(folder) && fs::is_empty(folder)))
    throw InputError(
        fmt::format("NAME: found {}, which exists, expected a new folder", folder.string()));
}

int write_new(const NewArguments& a) {
  const std::vector<TemplateFile> files = files_of(a.kind);
  const fs::path folder = a.folder;
  require_new(folder);
  for (const TemplateFile& f : files) {
    fs::create_directories((folder / f.path).parent_path());
    write_text(folder / f.path, f.text);
    print_out("{}\n", (folder / f.path).string());
  }
  const std::string first = (folder / files.front().path).string();
  const std::string output = (folder / "result").string();
  print_out("to {} it: tdbd {} {} -o {}{}\nevery key: tdbd keys\n",
            a.kind == "bit" ? "inspect" : "run", files.front().command, first, output,
            a.kind == "sweep" ? ".nc" : "");
  if (a.kind == "bit") print_out("columns of the table: tdbd keys cutter-table\n");
  return 0;
}

}  // namespace

void add_new(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("new", "Write an example case with all its files");
  auto a = std::make_shared<NewArguments>();
  command->add_option("kind", a->kind, "kind of example")
      ->required()
      ->type_name(fmt::format("{{{}}}", fmt::join(kinds(), ",")));
  command->add_option("name", a->folder, "name of the new folder")->required()->type_name(a_folder);
  command->footer(
      "pdc: a PDC bit with a given motion; bit: a bit file with a cutter table to start from; "
      "cones:\n"
      "a roller cone bit with a given motion; drilling: a PDC bit on a string under a weight; top: "
      "a\n"
      "heavy top; sweep: a design of many cases; calibration: measured readings and a law to fit.\n"
      "All files are in the new folder.\n"
      "Example: tdbd new pdc first");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return write_new(*a); }); });
}

namespace {

/// Two significant digits without an exponent: "0.42", "4.2", "42", "420".
std::string rounded(double x) {
  if (x < 10.0) return fmt::format("{:.2g}", x);
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1.0);
  return fmt::format("{:.0f}", std::round(x / unit) * unit);
}

/// "42 s", "7.2 min", "3.1 h".
std::string time_text(double seconds) {
  constexpr double minute = 60.0, hour = 3600.0;
  if (seconds < 2.0 * minute) return rounded(seconds) + " s";
  if (seconds < 2.0 * hour) return rounded(seconds / minute) + " min";
  return rounded(seconds / hour) + " h";
}

/// "38 MB", "1.4 GB".
std::string bytes_text(double bytes) {
  constexpr double mega = 1e6, giga = 1e9;
  return bytes < giga ? rounded(bytes / mega) + " MB" : rounded(bytes / giga) + " GB";
}

void print_estimate(const simulation::RunEstimate& e) {
  print_out("about {} triangles at the end, {} of memory, {} on disk", rounded(e.triangles),
            bytes_text(e.memory_bytes), bytes_text(e.disk_bytes));
  if (e.steps_tried > 0)
    print_out(", {} on this machine (from {})", time_text(e.seconds),
              counted(std::to_string(e.steps_tried), "trial step"));
  print_out("\n");
}

void check_run(const std::string& file, const std::vector<std::string>& overrides) {
  const simulation::Case c = simulation::read_case(file, overrides);
  simulation::Simulation s = simulation::start(c);
  print_warnings(c.warnings);
  print_warnings(simulation::reach_warnings(c, s.state.rock.surface));
  print_out("{}: valid; {}, {} triangles of rock, {} of {} s\n", file,
            counted(std::to_string(c.bit.parts.size()), "part"), s.state.start_triangles,
            counted(std::to_string(c.time.steps), "step"), c.time.step);
  print_estimate(simulation::estimate(c, s));
}

void check_rotate(const std::string& file, const std::vector<std::string>& overrides) {
  const simulation::RotateCase c = simulation::read_rotate_case(file, overrides);
  const simulation::RotateSimulation s = simulation::start(c);
  print_warnings(c.warnings);
  print_out("{}: valid; {}, {} of {} s, energy {:.6g} J\n", file,
            counted(std::to_string(c.body.cones.size()), "cone"),
            counted(std::to_string(c.time.steps), "step"), c.time.step, s.invariants.energy);
}

void check_string(const std::string& file, const std::vector<std::string>& overrides) {
  const simulation::ChainCase c = simulation::read_chain_case(file, overrides);
  simulation::start_chain(c);
  print_warnings(c.warnings);
  print_out("{}: valid; {} of {:.4g} m, {} of {} s\n", file,
            counted(std::to_string(c.plan.chain.count()), "element"), c.plan.chain.elements.length,
            counted(std::to_string(c.time.steps), "step"), c.time.step);
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "check", "Check a case, report all mistakes and their places, and estimate what a run takes");
  auto file = std::make_shared<std::string>();
  auto overrides = std::make_shared<std::vector<std::string>>();
  command->add_option("case", *file, "the case file (TOML)")->required()->type_name(a_toml_file);
  add_set(*command, *overrides, "override a key");
  command->footer("Example: tdbd check cases/bit-b-steady.toml");
  command->callback([file, overrides, &exit_code] {
    exit_code = guarded([&] {
      using simulation::CaseKind;
      simulation::require_kind(*file, *overrides,
                               {CaseKind::drilling, CaseKind::rotation, CaseKind::string});
      if (simulation::kind_of(*file, *overrides) == CaseKind::string)
        check_string(*file, *overrides);
      else if (simulation::is_rotate_case(*file))
        check_rotate(*file, *overrides);
      else
        check_run(*file, *overrides);
      return 0;
    });
  });
}

namespace {

constexpr const char* markdown_head =
    "# The keys of cases and bit files\n"
    "\n"
    "`tdbd keys --markdown` writes this file from the declarations (`visit` of each settings\n"
    "struct); do not edit it. A quantity is a number in the SI unit that is shown, or a text with\n"
    "any unit of the same dimension (`\"8.5 in\"`). Frame W: z down along the hole.\n"
    "\n";

constexpr const char* markdown_head_of_designs =
    "# The keys of a sweep's design\n"
    "\n"
    "`tdbd keys --design --markdown` writes this file from the declarations (`design.hpp`); do\n"
    "not edit it. A quantity is a number in the SI unit that is shown, or a text with any unit of\n"
    "the same dimension.\n"
    "\n";

struct KeysArguments {
  std::string table;
  bool markdown = false, design = false, search = false;
};

std::vector<KeyTable> tables_of_cases() {
  std::vector<KeyTable> tables = simulation::all_tables();
  for (const auto& more : {calibration::calibration_tables(), calibration::laboratory_tables()})
    tables.insert(tables.end(), more.begin(), more.end());
  tables.push_back(bit::cutter_table_keys());
  return tables;
}

/// Searches all tables, or those of a design.
int print_search(const KeysArguments& a) {
  std::vector<KeyTable> tables = a.design ? std::vector<KeyTable>() : tables_of_cases();
  const std::vector<KeyTable> design = sweep::design_tables();
  tables.insert(tables.end(), design.begin(), design.end());
  print_out("{}", keys_about(tables, a.table));
  return 0;
}

/// Whether a table has the name that is given.
bool names_table(const std::vector<KeyTable>& tables, const std::string& name) {
  return std::ranges::any_of(
      tables, [&](const KeyTable& t) { return t.name == name || t.name.starts_with(name + "."); });
}

int print_keys(const KeysArguments& a) {
  std::vector<KeyTable> tables = a.design ? sweep::design_tables() : tables_of_cases();
  if (!a.table.empty() && !a.markdown && (a.search || !names_table(tables, a.table)))
    return print_search(a);
  if (!a.table.empty())
    tables = tables_named(tables, a.table, a.design ? "tdbd keys --design" : "tdbd keys");
  if (a.markdown)
    print_out("{}{}", a.design ? markdown_head_of_designs : markdown_head,
              keys_as_markdown(tables));
  else
    print_out("{}", keys_as_text(tables));
  if (!a.markdown && tables.size() == 1 && tables.front().name == bit::cutter_table_keys().name)
    print_out("{}", bit::cutter_table_notes);
  return 0;
}

}  // namespace

void add_keys(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "keys", "List the keys of cases, bit files and designs: units, defaults, ranges, meanings");
  auto a = std::make_shared<KeysArguments>();
  command
      ->add_option("table", a->table,
                   "name of a table, such as motion, with its subtables; or words, such as "
                   "\"weight\": all keys of cases, bits and designs that have them in their name "
                   "or meaning; default: all tables")
      ->type_name("TABLE|WORDS");
  command->add_flag("--search", a->search, "search for the words even if a table has that name");
  command->add_flag("--design", a->design, "the keys of a sweep's design instead");
  command->add_flag("--markdown", a->markdown, "as Markdown");
  command->footer(
      "cutter-table: the columns of a cutter table. A search prints at most 60 lines.\n"
      "Example: tdbd keys weight");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return print_keys(*a); }); });
}

}  // namespace tdbd::app
