#include "core/config/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "core/text.hpp"

namespace tdbd {
namespace {

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> cells;
  std::size_t comma = 0;
  while ((comma = line.find(',')) != std::string_view::npos) {
    cells.emplace_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  cells.emplace_back(trimmed(line));
  return cells;
}

void check_header(const CsvRow& row, CsvMistakes& mistakes) {
  std::map<std::string_view, int> times;
  for (const std::string& name : row.cells) ++times[name];
  for (const std::string& name : row.cells) {
    if (name.empty() || csv_number<double>(name))
      mistakes.add(row.line, "header", fmt::format("\"{}\"", name), "the name of a column");
    if (times[name] > 1)
      mistakes.add(row.line, "header", fmt::format("\"{}\" twice", name), "different names");
  }
}

void add_row(CsvTable& table, const CsvRow& text, CsvMistakes& mistakes) {
  if (text.cells.size() != table.header.size()) {
    mistakes.add(text.line, "row", fmt::format("{} values", text.cells.size()),
                 fmt::format("{}, as in the header", table.header.size()));
    return;
  }
  std::vector<double> row;
  for (std::size_t i = 0; i < text.cells.size(); ++i) {
    const std::optional<double> value = csv_number<double>(text.cells[i]);
    if (!value)
      mistakes.add(text.line, table.header[i], fmt::format("\"{}\"", text.cells[i]),
                   "a finite number");
    row.push_back(value.value_or(0.0));
  }
  table.rows.push_back(std::move(row));
  table.lines.push_back(text.line);
}

}  // namespace

std::vector<CsvRow> read_csv_rows(const std::string& path) {
  std::istringstream in(read_file(path, "a CSV table"));
  std::vector<CsvRow> rows;
  std::string text;
  for (long line = 1; std::getline(in, text); ++line) {
    std::string_view body = text;
    if (line == 1 && body.substr(0, 3) == "\xef\xbb\xbf") body.remove_prefix(3);
    body = trimmed(body);
    if (!body.empty() && body.front() != '#') rows.push_back({line, split(body)});
  }
  return rows;
}

void CsvMistakes::add(long line, std::string_view column, std::string_view found,
                      std::string_view expected) {
  lines.push_back(
      fmt::format("{}:{}: {}: found {}, expected {}", file, line, column, found, expected));
}

void CsvMistakes::throw_if_any() const {
  if (!lines.empty()) throw InputError(fmt::format("{}", fmt::join(lines, "\n")));
}

CsvTable read_csv(const std::string& path) {
  CsvTable table{path, {}, {}, {}};
  CsvMistakes mistakes{path};
  for (const CsvRow& row : read_csv_rows(path)) {
    if (!table.header.empty()) {
      add_row(table, row, mistakes);
      continue;
    }
    check_header(row, mistakes);
    table.header = row.cells;
  }
  if (table.header.empty()) mistakes.add(1, "header", "nothing", "the names of the columns");
  mistakes.throw_if_any();
  return table;
}

std::size_t csv_column(const CsvTable& table, std::string_view name) {
  const auto place = std::find(table.header.begin(), table.header.end(), name);
  if (place != table.header.end()) return static_cast<std::size_t>(place - table.header.begin());
  const auto near = nearest_name(name, table.header);
  const std::string found = near ? fmt::format("the column {}", *near) : "no such column";
  throw InputError(
      fmt::format("{}: {}: found {}, expected a column of this name", table.file, name, found));
}

}  // namespace tdbd
