#include "calibration/record/record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <regex>

#include "core/config/csv.hpp"
#include "core/config/field.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace tdbd::calibration {
namespace {

enum class Need { required, optional };

/// A column that a file may have. `si_unit` is empty for text.
struct Column {
  std::string name, si_unit;
  Need need = Need::required;
  Range range = Range::positive();
};

std::vector<Column> columns_of(ToolKind kind) {
  const auto [first, second] = load_names(kind);
  std::vector<Column> columns{
      {"test", ""}, {kind == ToolKind::bit ? "bit" : "cutter", ""}, {"rock", "", Need::optional}};
  if (kind == ToolKind::bit) {
    columns.push_back({"pressure", "Pa", Need::required, Range::non_negative()});
    columns.push_back({"rotary_speed", "rad/s"});
    columns.push_back({"rate_of_penetration", "m/s"});
  } else {
    columns.push_back({"pressure", "Pa", Need::optional, Range::non_negative()});
    columns.push_back({"speed", "m/s"});
    columns.push_back({"depth", "m"});
  }
  columns.push_back({first.name, first.si_unit});
  columns.push_back({second.name, second.si_unit, Need::optional});
  columns.push_back({fmt::format("{}_sd", first.name), first.si_unit, Need::optional});
  columns.push_back({fmt::format("{}_sd", second.name), second.si_unit, Need::optional});
  return columns;
}

/// Splits "wob [kN]" into name and unit. Upper and lower case are the same, and so are
/// "Rotary speed" and "rotary_speed".
NamedUnit name_and_unit(const std::string& cell) {
  NamedUnit column = split_unit(cell);
  column.name = lower_case(column.name);
  std::ranges::replace_if(
      column.name, [](char c) { return c == ' ' || c == '-'; }, '_');
  return column;
}

/// Index and unit of a column of the file.
struct Place {
  std::size_t cell = 0;
  std::string unit;
};
using Places = std::map<std::string, Place>;

void check_unit(const Column& column, const std::string& unit, long line, CsvMistakes& mistakes) {
  if (column.si_unit.empty()) {
    if (!unit.empty()) mistakes.add(line, column.name, "a unit", "a text, without a unit");
    return;
  }
  try {
    to_si("1 " + unit, column.si_unit);
  } catch (const UnitError& e) {
    // The message quotes only the unit, because that is what the file contains.
    const std::string found = std::regex_replace(e.found, std::regex("^\"1 "), "\"");
    mistakes.add(line, column.name, unit.empty() ? "no unit" : found,
                 fmt::format("{} [unit], {}", column.name, e.expected));
  }
}

Places read_header(const CsvRow& header, const std::vector<Column>& columns,
                   CsvMistakes& mistakes) {
  std::vector<std::string> known;
  known.reserve(columns.size());
  for (const Column& c : columns) known.push_back(c.name);
  Places places;
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    const auto [name, unit] = name_and_unit(header.cells[i]);
    const auto column = std::ranges::find(columns, name, &Column::name);
    if (column == columns.end()) {
      const auto near = nearest_name(name, known);
      mistakes.add(
          header.line, name, "an unknown column",
          near ? fmt::format("{}?", *near) : fmt::format("one of {}", fmt::join(known, ", ")));
      continue;
    }
    check_unit(*column, unit, header.line, mistakes);
    if (!places.try_emplace(name, Place{i, unit}).second)
      mistakes.add(header.line, name, "the column twice", "it once");
  }
  for (const Column& c : columns)
    if (c.need == Need::required && !places.contains(c.name))
      mistakes.add(header.line, c.name, "no such column", "it in the header");
  return places;
}

/// Reads the cells of one row.
struct RowReader {
  const CsvRow& row;
  const Places& places;
  const std::vector<Column>& columns;
  CsvMistakes& mistakes;
  std::vector<std::string>& doubts;

  /// Numbers that logs contain where there was no reading.
  static bool is_null(double x) { return x == 999.25 || x == 9999.0 || x == 99999.0; }

  std::string cell(const std::string& name) const {
    const auto place = places.find(name);
    return place == places.end() ? "" : row.cells[place->second.cell];
  }

  std::string text(const std::string& name) const {
    const std::string value = cell(name);
    if (value.empty()) mistakes.add(row.line, name, "nothing", "a name");
    return value;
  }

  /// The value in SI; nothing for an empty cell or after a mistake.
  std::optional<double> number(const std::string& name) const {
    const std::string value = cell(name);
    if (value.empty()) return std::nullopt;
    const Column& column = *std::ranges::find(columns, name, &Column::name);
    const auto read = csv_number<double>(value);
    const std::string expected = fmt::format("a number{}", column.range.text());
    if (!read || !column.range.contains(*read)) {
      mistakes.add(row.line, name, value, expected + comma_hint(value));
      return std::nullopt;
    }
    if (is_null(*read))
      doubts.push_back(
          fmt::format("{}:{}: {}: {} usually means \"no value\" in logs; leave the cell "
                      "empty, or leave out the row",
                      mistakes.file, row.line, name, value));
    return to_si(fmt::format("{} {}", value, places.at(name).unit), column.si_unit);
  }

  double needed(const std::string& name) const {
    if (cell(name).empty()) mistakes.add(row.line, name, "nothing", "a number");
    return number(name).value_or(1.0);
  }
};

Record read_row(const RowReader& r, ToolKind kind) {
  Record record;
  record.line = r.row.line;
  record.test = r.text("test");
  record.rock = r.cell("rock");
  if (kind == ToolKind::bit) {
    record.tool = r.text("bit");
    record.pressure = r.needed("pressure");
    record.speed = r.needed("rotary_speed");
    record.rate = r.needed("rate_of_penetration");
    record.depth = record.rate * 2.0 * std::numbers::pi / record.speed;
  } else {
    record.tool = r.text("cutter");
    record.pressure = r.number("pressure").value_or(0.0);
    record.speed = r.needed("speed");
    record.depth = r.needed("depth");
  }
  const auto names = load_names(kind);
  for (const std::size_t k : {axial, turning})
    record.readings[k] = {r.number(names[k].name), r.number(fmt::format("{}_sd", names[k].name))};
  return record;
}

/// A file with a column "cutter" contains tests of single cutters.
ToolKind kind_of(const CsvRow& header) {
  const bool cutters = std::ranges::any_of(
      header.cells, [](const std::string& cell) { return name_and_unit(cell).name == "cutter"; });
  return cutters ? ToolKind::cutter : ToolKind::bit;
}

void reject_duplicate_rows(const std::vector<CsvRow>& rows, CsvMistakes& mistakes) {
  std::map<std::vector<std::string>, long> seen;
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (const auto [at, fresh] = seen.try_emplace(rows[i].cells, rows[i].line); !fresh)
      mistakes.add(rows[i].line, "row", fmt::format("line {} again", at->second),
                   "each reading once; a repeat is a test of its own name");
}

}  // namespace

Records read_records(const std::string& path) {
  const std::vector<CsvRow> rows = read_csv_rows(path);
  CsvMistakes mistakes{path};
  if (rows.size() < 2) mistakes.add(1, "records", "no rows", "a header and a row for each reading");
  mistakes.throw_if_any();
  Records records{path, kind_of(rows.front()), {}, {}};
  const std::vector<Column> columns = columns_of(records.kind);
  const Places places = read_header(rows.front(), columns, mistakes);
  mistakes.throw_if_any();
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].cells.size() != rows.front().cells.size()) {
      mistakes.add(rows[i].line, "row", fmt::format("{} cells", rows[i].cells.size()),
                   fmt::format("{}, as in the header", rows.front().cells.size()));
      continue;
    }
    records.rows.push_back(
        read_row({rows[i], places, columns, mistakes, records.doubts}, records.kind));
  }
  reject_duplicate_rows(rows, mistakes);
  mistakes.throw_if_any();
  return records;
}

}  // namespace tdbd::calibration
