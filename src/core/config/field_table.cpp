#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "core/read_file.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace tdbd {
namespace {

void demand_width(const FieldTable& t, const CsvRow& row) {
  if (row.cells.size() != t.names.size())
    refuse_table(t.file, row.line, "row", fmt::format("{} values", row.cells.size()),
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
  if (section == 'V' && lower_case(l.name) == "wrap" && lower_case(l.value) == "yes")
    refuse_table(t.file, line.line, "WRAP", "YES", "NO: one line for each row");
  if (section == 'W' && lower_case(l.name) == "null")
    if (const auto null = csv_number<double>(l.value)) t.null = *null;
  if (section != 'C') return;
  t.names.push_back(l.name);
  t.units.push_back(l.unit);
}

FieldTable read_las(const std::string& path) {
  FieldTable t{path, {}, {}, {}};
  std::istringstream in(read_text_file(path, "a LAS file"));
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
    refuse_table(path, 1, "~Curve", "no columns", "a section of LAS 2.0 that names them");
  return t;
}

/// Returns the value of one unit in SI. Names in capitals, as in LAS files, are also tried in lower
/// case; then kn is a knot unless a force is expected.
std::optional<double> factor_of(const std::string& unit, const std::string& si_unit) {
  const std::string small = lower_case(unit);
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
  FieldTable t = lower_case(path).ends_with(".las") ? read_las(path) : read_csv_table(path);
  if (t.rows.empty()) refuse_table(path, 1, "rows", "none", "a row of values for each time");
  return t;
}

std::vector<double> field_column(const FieldTable& t, std::string_view column,
                                 const std::string& si_unit) {
  const NamedUnit wanted = split_unit(column);
  auto place = std::ranges::find(t.names, wanted.name);
  if (place == t.names.end())
    place = std::ranges::find(t.names, lower_case(wanted.name),
                              [](const std::string& name) { return lower_case(name); });
  if (place == t.names.end())
    refuse_table(t.file, 1, wanted.name, "no column of this name",
                 fmt::format("one of {}", fmt::join(t.names, ", ")));
  const auto k = static_cast<std::size_t>(place - t.names.begin());
  const std::string unit = wanted.unit.empty() ? t.units[k] : wanted.unit;
  if (unit.empty())
    refuse_table(
        t.file, 1, wanted.name, "no unit",
        fmt::format("one in the header or in the case, as in \"{} [{}]\"", wanted.name, si_unit));
  const std::optional<double> factor = factor_of(unit, si_unit);
  if (!factor)
    refuse_table(t.file, 1, wanted.name, fmt::format("the unit \"{}\"", unit),
                 fmt::format("a unit of {}", describe_unit(si_unit)));
  std::vector<double> values;
  values.reserve(t.rows.size());
  for (const CsvRow& row : t.rows) {
    const std::optional<double> value = csv_number<double>(row.cells[k]);
    if (!value || *value == t.null)
      refuse_table(t.file, row.line, wanted.name, fmt::format("no value, \"{}\"", row.cells[k]),
                   "a number in each row: fill the gap or cut the record");
    values.push_back(*value * *factor);
  }
  return values;
}

}  // namespace tdbd
