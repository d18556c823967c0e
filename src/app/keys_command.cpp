#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/print.hpp"
#include "calibration/case/calibration_tables.hpp"
#include "calibration/laboratory/laboratory_tables.hpp"
#include "simulation/case/key_tables.hpp"

namespace tdbd::app {
namespace {

constexpr const char* markdown_head =
    "# The keys of cases and bit files\n"
    "\n"
    "`tdbd keys --markdown` writes this file from the declarations (`*_keys.hpp`); do not edit it. "
    "A quantity is a number\n"
    "in the SI unit that is shown, or a text with any unit of the same dimension (`\"8.5 in\"`). "
    "Frame W: z down along the hole.\n"
    "\n";

int print_keys(const std::string& table, bool markdown) {
  std::vector<KeyTable> tables = simulation::all_tables();
  for (const auto& more : {calibration::calibration_tables(), calibration::laboratory_tables()})
    tables.insert(tables.end(), more.begin(), more.end());
  if (!table.empty()) tables = tables_named(tables, table);
  if (markdown)
    say("{}{}", markdown_head, keys_as_markdown(tables));
  else
    say("{}", keys_as_text(tables));
  return 0;
}

}  // namespace

void add_keys(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "keys", "List the keys of cases and bit files: units, defaults, ranges, meanings");
  auto table = std::make_shared<std::string>();
  auto markdown = std::make_shared<bool>(false);
  command->add_option("table", *table, "a table, with those inside it: motion; default: all");
  command->add_flag("--markdown", *markdown, "as Markdown");
  command->footer("Example: tdbd keys motion");
  command->callback([table, markdown, &exit_code] {
    exit_code = guarded([&] { return print_keys(*table, *markdown); });
  });
}

}  // namespace tdbd::app
