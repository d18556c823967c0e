#include <fmt/format.h>

#include <array>

#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"

namespace tdbd::reference {
namespace {

/// A column of the file and its destination.
struct ToothColumn {
  std::string name, si_unit;
  std::vector<double>* values;
  std::size_t cell = 0;
  double unit = 0.0;  ///< in SI; 0: the file does not have this column
};

/// Splits "force [kN]" into name and unit; without brackets the unit is empty.
std::pair<std::string, std::string> halves(const std::string& cell) {
  const std::size_t open = cell.find(" [");
  if (open == std::string::npos || cell.back() != ']') return {cell, ""};
  return {cell.substr(0, open), cell.substr(open + 2, cell.size() - open - 3)};
}

void read_columns(std::array<ToothColumn, 3>& columns, const CsvRow& header,
                  CsvMistakes& mistakes) {
  for (ToothColumn& c : columns) {
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
      const auto [name, unit] = halves(header.cells[i]);
      if (name != c.name) continue;
      try {
        c.unit = to_si("1 " + unit, c.si_unit);
        c.cell = i;
      } catch (const UnitError& e) {
        mistakes.add(header.line, c.name, e.found, e.expected);
        c.unit = 1.0;
      }
    }
    if (c.unit == 0.0)
      mistakes.add(header.line, c.name, "no such column",
                   fmt::format("\"{} [unit]\" in the header", c.name));
  }
}

void read_row(const std::array<ToothColumn, 3>& columns, const CsvRow& row, CsvMistakes& mistakes) {
  for (const ToothColumn& c : columns) {
    const auto value =
        c.cell < row.cells.size() ? csv_number<double>(row.cells[c.cell]) : std::optional<double>();
    if (!value)
      mistakes.add(row.line, c.name, c.cell < row.cells.size() ? row.cells[c.cell] : "nothing",
                   "a finite number");
    c.values->push_back(value.value_or(0.0) * c.unit);
  }
}

}  // namespace

ToothTable read_tooth_table(const std::string& path, std::string_view model) {
  const std::vector<CsvRow> rows = read_csv_rows(path);
  ToothTable table;
  table.source = path;
  CsvMistakes mistakes{path};
  std::array<ToothColumn, 3> columns{{{"depth", "m", &table.depth},
                                      {"force", "N", &table.force},
                                      {"crater_radius", "m", &table.radius}}};
  if (rows.empty()) mistakes.add(1, "header", "nothing", "depth, force, crater_radius");
  if (!rows.empty()) read_columns(columns, rows[0], mistakes);
  for (std::size_t i = 1; i < rows.size() && mistakes.lines.empty(); ++i) {
    read_row(columns, rows[i], mistakes);
    table.lines.push_back(rows[i].line);
  }
  if (!mistakes.lines.empty())
    throw InputError(fmt::format("{}: {}", model, fmt::join(mistakes.lines, "\n")));
  check_tooth_law(table, model);
  return table;
}

}  // namespace tdbd::reference
