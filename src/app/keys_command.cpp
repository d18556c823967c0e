#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/print.hpp"
#include "calibration/case/calibration_tables.hpp"
#include "calibration/laboratory/laboratory_tables.hpp"
#include "simulation/case/key_tables.hpp"
#include "sweep/design/design_tables.hpp"

namespace tdbd::app {
namespace {

constexpr const char* markdown_head =
    "# The keys of cases and bit files\n"
    "\n"
    "`tdbd keys --markdown` writes this file from the declarations (`*_keys.hpp`); do not edit it. "
    "A quantity is\n"
    "a number in the SI unit that is shown, or a text with any unit of the same dimension\n"
    "(`\"8.5 in\"`). Frame W: z down along the hole.\n"
    "\n";

constexpr const char* markdown_head_of_designs =
    "# The keys of a sweep's design\n"
    "\n"
    "`tdbd keys --design --markdown` writes this file from the declarations (`design_keys.hpp`); "
    "do "
    "not edit it. A quantity is a\n"
    "number in the SI unit that is shown, or a text with any unit of the same dimension.\n"
    "\n";

struct KeysArguments {
  std::string table;
  bool markdown = false, design = false;
};

std::vector<KeyTable> tables_of_cases() {
  std::vector<KeyTable> tables = simulation::all_tables();
  for (const auto& more : {calibration::calibration_tables(), calibration::laboratory_tables()})
    tables.insert(tables.end(), more.begin(), more.end());
  return tables;
}

int print_keys(const KeysArguments& a) {
  std::vector<KeyTable> tables = a.design ? sweep::design_tables() : tables_of_cases();
  if (!a.table.empty())
    tables = tables_named(tables, a.table, a.design ? "tdbd keys --design" : "tdbd keys");
  if (a.markdown)
    say("{}{}", a.design ? markdown_head_of_designs : markdown_head, keys_as_markdown(tables));
  else
    say("{}", keys_as_text(tables));
  return 0;
}

}  // namespace

void add_keys(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "keys", "List the keys of cases, bit files and designs: units, defaults, ranges, meanings");
  auto a = std::make_shared<KeysArguments>();
  command
      ->add_option("table", a->table,
                   "name of a table, such as motion; includes its subtables; default: all")
      ->type_name("TABLE");
  command->add_flag("--design", a->design, "the keys of a sweep's design instead");
  command->add_flag("--markdown", a->markdown, "as Markdown");
  command->footer("Example: tdbd keys motion");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return print_keys(*a); }); });
}

}  // namespace tdbd::app
