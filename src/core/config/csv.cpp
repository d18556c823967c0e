#include "core/config/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/text.hpp"

namespace tdbd {
namespace {

std::vector<std::string> split_cells(std::string_view line) {
  std::vector<std::string> cells;
  std::size_t comma = 0;
  while ((comma = line.find(',')) != std::string_view::npos) {
    cells.emplace_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  cells.emplace_back(trimmed(line));
  return cells;
}

/// A finite number that fills the whole cell.
std::optional<double> finite_number(const std::string& cell) {
  double value = 0.0;
  const char* end = cell.data() + cell.size();
  const auto [rest, error] = std::from_chars(cell.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Collects the mistakes of one file.
struct Problems {
  std::string file;
  std::string text;

  void add(long line, const std::string& column, const std::string& found,
           const std::string& expected) {
    if (!text.empty()) text += '\n';
    text += fmt::format("{}:{}: {}: found {}, expected {}", file, line, column, found, expected);
  }
};

void add_header(CsvTable& table, const CsvRow& row, Problems& problems) {
  for (const std::string& name : row.cells) {
    if (name.empty() || finite_number(name))
      problems.add(row.line, "header", fmt::format("\"{}\"", name), "the name of a column");
    if (std::count(row.cells.begin(), row.cells.end(), name) > 1)
      problems.add(row.line, "header", fmt::format("\"{}\" twice", name), "different names");
  }
  table.header = row.cells;
}

void add_row(CsvTable& table, const CsvRow& row, Problems& problems) {
  if (row.cells.size() != table.header.size()) {
    problems.add(row.line, "row", fmt::format("{} values", row.cells.size()),
                 fmt::format("{}, as in the header", table.header.size()));
    return;
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const std::optional<double> value = finite_number(row.cells[i]);
    if (!value)
      problems.add(row.line, table.header[i], fmt::format("\"{}\"", row.cells[i]),
                   "a finite number");
    numbers.push_back(value.value_or(0.0));
  }
  table.rows.push_back(std::move(numbers));
  table.lines.push_back(row.line);
}

}  // namespace

std::vector<CsvRow> read_csv_rows(const std::string& path) {
  std::ifstream in(path);
  if (!in || !std::filesystem::is_regular_file(path))
    throw InputError(fmt::format("{}: found no such file, expected a CSV table", path));
  std::vector<CsvRow> rows;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    std::string_view body = text;
    if (line == 1 && body.substr(0, 3) == "\xef\xbb\xbf") body.remove_prefix(3);
    body = trimmed(body);
    if (!body.empty() && body.front() != '#') rows.push_back({line, split_cells(body)});
  }
  return rows;
}

CsvTable read_csv(const std::string& path) {
  CsvTable table{path, {}, {}, {}};
  Problems problems{path, ""};
  for (const CsvRow& row : read_csv_rows(path)) {
    if (table.header.empty())
      add_header(table, row, problems);
    else
      add_row(table, row, problems);
  }
  if (table.header.empty()) problems.add(1, "header", "nothing", "the names of the columns");
  if (!problems.text.empty()) throw InputError(problems.text);
  return table;
}

std::size_t csv_column(const CsvTable& table, std::string_view name) {
  const auto at = std::find(table.header.begin(), table.header.end(), name);
  if (at != table.header.end()) return static_cast<std::size_t>(at - table.header.begin());
  const auto near = nearest_name(name, table.header);
  const std::string found = near ? fmt::format("the column {}", *near) : "no such column";
  throw InputError(
      fmt::format("{}: {}: found {}, expected a column of this name", table.file, name, found));
}

}  // namespace tdbd
