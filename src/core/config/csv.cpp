#include "core/config/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace tdbd {
namespace {

/// Takes the first cell from a line. A cell in double quotes may contain the separator; two quotes
/// in it are one quote.
std::string take_cell(std::string_view& line, char separator) {
  const std::size_t from = line.find_first_not_of(" ");
  if (from == std::string_view::npos || line[from] != '"') {
    const std::size_t end = std::min(line.find(separator), line.size());
    std::string cell(trimmed(line.substr(0, end)));
    line.remove_prefix(end);
    return cell;
  }
  line.remove_prefix(from + 1);
  std::string cell;
  while (!line.empty()) {
    const char c = line.front();
    line.remove_prefix(1);
    if (c == '"' && !line.starts_with('"')) break;
    if (c == '"') line.remove_prefix(1);
    cell += c;
  }
  const std::size_t end = std::min(line.find(separator), line.size());
  cell += trimmed(line.substr(0, end));  // behind the closing quote
  line.remove_prefix(end);
  return cell;
}

/// "50,5" as "50.5"; other cells are unchanged.
std::string with_decimal_point(std::string cell) {
  const std::size_t comma = cell.find(',');
  if (comma == std::string::npos) return cell;
  std::string other = cell;
  other[comma] = '.';
  return csv_number<double>(other) ? other : cell;
}

std::vector<std::string> split(std::string_view line, char separator) {
  std::vector<std::string> cells;
  while (true) {
    std::string cell = take_cell(line, separator);
    cells.push_back(separator == ',' ? std::move(cell) : with_decimal_point(std::move(cell)));
    if (line.empty()) return cells;
    line.remove_prefix(1);
  }
}

/// The separator that is most frequent in the header.
char separator_of(std::string_view header) {
  char best = ',';
  for (const char c : {';', '\t'})
    if (std::ranges::count(header, c) > std::ranges::count(header, best)) best = c;
  return best;
}

/// Rejects workbooks and UTF-16, which spreadsheet programs also write.
void require_text(const std::string& path, const std::string& bytes) {
  const bool workbook = bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0");
  if (workbook)
    throw InputError(fmt::format(
        "{}:1: table: found a workbook of a spreadsheet program, expected a CSV table: save the "
        "sheet as \"CSV UTF-8\" (Excel: File, Save As; LibreOffice: File, Save As, Text CSV)",
        path));
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    throw InputError(
        fmt::format("{}:1: table: found text in UTF-16, expected UTF-8: save the sheet as "
                    "\"CSV UTF-8\"",
                    path));
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
  const std::string bytes = read_file(path, "a CSV table");
  require_text(path, bytes);
  std::istringstream in(bytes);
  std::vector<CsvRow> rows;
  std::string text;
  char separator = ',';
  for (long line = 1; std::getline(in, text); ++line) {
    std::string_view body = text;
    if (line == 1 && body.substr(0, 3) == "\xef\xbb\xbf") body.remove_prefix(3);
    // Tabs at the ends are separators if the table uses them.
    const std::string_view content = trimmed(body);
    if (content.empty() || content.front() == '#') continue;
    if (rows.empty()) separator = separator_of(content);
    std::vector<std::string> cells = split(separator == '\t' ? body : content, separator);
    if (separator == '\t' && !cells.empty()) cells.back() = trimmed(cells.back());
    if (std::ranges::any_of(cells, [](const std::string& c) { return !c.empty(); }))
      rows.push_back({line, std::move(cells)});
  }
  return rows;
}

void CsvMistakes::add(long line, std::string_view column, std::string_view found,
                      std::string_view expected) {
  lines.push_back(
      fmt::format("{}:{}: {}: found {}, expected {}", file, line, column, found, expected));
}

void CsvMistakes::throw_if_any() const {
  constexpr std::size_t most = 40;
  if (lines.empty()) return;
  const std::size_t listed = std::min(most, lines.size());
  std::string text =
      fmt::format("{}", fmt::join(lines.begin(), lines.begin() + static_cast<long>(listed), "\n"));
  if (listed < lines.size())
    text += fmt::format("\n{}: found {} more mistakes, expected none", file, lines.size() - listed);
  throw InputError(text);
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

namespace {

std::string lower(std::string_view text) {
  std::string s(text);
  for (char& c : s) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return s;
}

/// Splits "hook load [kN]" or "hook load (kN)"; without brackets there is no unit.
struct NamedUnit {
  std::string name, unit;
};
NamedUnit split_unit(std::string_view text) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
    const std::size_t from = text.rfind(open);
    if (text.empty() || text.back() != close || from == std::string_view::npos) continue;
    return {std::string(trimmed(text.substr(0, from))),
            std::string(trimmed(text.substr(from + 1, text.size() - from - 2)))};
  }
  return {std::string(text), ""};
}

[[noreturn]] void refuse(const std::string& file, long line, std::string_view what,
                         std::string_view found, std::string_view expected) {
  CsvMistakes mistakes{file};
  mistakes.add(line, what, found, expected);
  mistakes.throw_if_any();
  throw InputError(file);
}

void demand_width(const FieldTable& t, const CsvRow& row) {
  if (row.cells.size() != t.names.size())
    refuse(t.file, row.line, "row", fmt::format("{} values", row.cells.size()),
           fmt::format("{}, one for each column", t.names.size()));
}

FieldTable read_csv_table(const std::string& path) {
  FieldTable t{path, {}, {}, {}};
  for (CsvRow& row : read_csv_rows(path)) {
    if (t.names.empty()) {
      for (const std::string& cell : row.cells) {
        NamedUnit column = split_unit(cell);
        t.names.push_back(std::move(column.name));
        t.units.push_back(std::move(column.unit));
      }
      continue;
    }
    demand_width(t, row);
    t.rows.push_back(std::move(row));
  }
  return t;
}

/// Splits a line of a section other than ~A: "MNEM.UNIT   VALUE : DESCRIPTION".
struct LasLine {
  std::string name, unit, value;
};
LasLine las_line(std::string_view text) {
  const std::size_t dot = text.find('.');
  LasLine l{std::string(trimmed(text.substr(0, dot))), "", ""};
  if (dot == std::string_view::npos) return l;
  text.remove_prefix(dot + 1);
  const std::size_t blank = std::min(text.find_first_of(" \t:"), text.size());
  l.unit = text.substr(0, blank);
  text.remove_prefix(blank);
  l.value = trimmed(text.substr(0, text.rfind(':')));
  return l;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

void take_las_line(char section, const CsvRow& line, FieldTable& t) {
  const LasLine l = las_line(line.cells[0]);
  if (section == 'V' && lower(l.name) == "wrap" && lower(l.value) == "yes")
    refuse(t.file, line.line, "WRAP", "YES", "NO: one line for each row");
  if (section == 'W' && lower(l.name) == "null")
    if (const auto null = csv_number<double>(l.value)) t.null = *null;
  if (section != 'C') return;
  t.names.push_back(l.name);
  t.units.push_back(l.unit);
}

FieldTable read_las(const std::string& path) {
  FieldTable t{path, {}, {}, {}};
  std::istringstream in(read_file(path, "a LAS file"));
  char section = ' ';
  std::string text;
  for (long line = 1; std::getline(in, text); ++line) {
    const std::string_view body = trimmed(text);
    if (body.empty() || body.front() == '#') continue;
    if (body.front() == '~') {
      section = body.size() > 1 ? static_cast<char>(std::toupper(body[1])) : ' ';
    } else if (section == 'A') {
      t.rows.push_back({line, words_of(text)});
      demand_width(t, t.rows.back());
    } else {
      take_las_line(section, {line, {std::string(body)}}, t);
    }
  }
  if (t.names.empty())
    refuse(path, 1, "~Curve", "no columns", "a section of LAS 2.0 that names them");
  return t;
}

/// Returns the value of one unit in SI. Names in capitals, as in LAS files, are also tried in lower
/// case; then kn is a knot unless a force is expected.
std::optional<double> factor_of(const std::string& unit, const std::string& si_unit) {
  const std::string small = lower(unit);
  for (const std::string& each : {unit, small, std::string(small == "kn" ? "kN" : small)}) {
    try {
      return to_si("1 " + each, si_unit);
    } catch (const UnitError&) {
    }
  }
  return std::nullopt;
}

}  // namespace

FieldTable read_field_table(const std::string& path) {
  FieldTable t = lower(path).ends_with(".las") ? read_las(path) : read_csv_table(path);
  if (t.rows.empty()) refuse(path, 1, "rows", "none", "a row of values for each time");
  return t;
}

std::vector<double> field_column(const FieldTable& t, std::string_view column,
                                 const std::string& si_unit) {
  const NamedUnit wanted = split_unit(column);
  const auto place = std::find(t.names.begin(), t.names.end(), wanted.name);
  if (place == t.names.end())
    refuse(t.file, 1, wanted.name, "no column of this name",
           fmt::format("one of {}", fmt::join(t.names, ", ")));
  const auto k = static_cast<std::size_t>(place - t.names.begin());
  const std::string unit = wanted.unit.empty() ? t.units[k] : wanted.unit;
  if (unit.empty())
    refuse(
        t.file, 1, wanted.name, "no unit",
        fmt::format("one in the header or in the case, as in \"{} [{}]\"", wanted.name, si_unit));
  const std::optional<double> factor = factor_of(unit, si_unit);
  if (!factor)
    refuse(t.file, 1, wanted.name, fmt::format("the unit \"{}\"", unit),
           fmt::format("a unit of {}", describe_unit(si_unit)));
  std::vector<double> values;
  values.reserve(t.rows.size());
  for (const CsvRow& row : t.rows) {
    const std::optional<double> value = csv_number<double>(row.cells[k]);
    if (!value || *value == t.null)
      refuse(t.file, row.line, wanted.name, fmt::format("no value, \"{}\"", row.cells[k]),
             "a number in each row: fill the gap or cut the record");
    values.push_back(*value * *factor);
  }
  return values;
}

}  // namespace tdbd
