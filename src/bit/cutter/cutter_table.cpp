#include "bit/cutter/cutter_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "bit/cutter/cutter.hpp"
#include "bit/cutter/cutter_columns.hpp"
#include "core/config/csv.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

void read_integer(const CsvRow& row, const CutterColumns& columns, std::string_view name,
                  int& value, CsvMistakes& mistakes) {
  const std::string& cell = row.cells[columns.labels.find(name)->second];
  if (const auto number = csv_number<int>(cell))
    value = *number;
  else
    mistakes.add(row.line, name, '\'' + cell + '\'', "a whole number");
}

/// A number outside the range of its column.
struct OutOfRange {
  long line = 0;
  std::string name, cell, expected;
  bool is_negative = false;
};

/// Adds one line for each number, or one for a column in which many are outside.
void add_out_of_range(const std::vector<OutOfRange>& all, CsvMistakes& mistakes) {
  constexpr std::ptrdiff_t few = 3;
  std::vector<std::string_view> summed_up;
  for (const OutOfRange& first : all) {
    const auto is_alike = [&](const OutOfRange& o) { return o.name == first.name; };
    const auto count = std::ranges::count_if(all, is_alike);
    if (count <= few) mistakes.add(first.line, first.name, first.cell, first.expected);
    if (count <= few || std::ranges::count(summed_up, first.name) > 0) continue;
    summed_up.emplace_back(first.name);
    const bool negative = std::ranges::all_of(
        all, [&](const OutOfRange& o) { return o.is_negative || !is_alike(o); });
    const bool rake = first.name.starts_with("back_rake");
    mistakes.add(
        first.line, first.name,
        fmt::format("{} and {} more values outside the range", first.cell, count - 1),
        first.expected + (!negative ? ""
                          : rake ? ": positive rakes lean back; change the sign of the column, or "
                                   "are back and side rakes swapped?"
                                 : ": is the sign of the column wrong?"));
  }
}

void read_number(const CsvRow& row, const CutterColumns::Number& use, Cutter& cutter,
                 std::vector<OutOfRange>& outside, CsvMistakes& mistakes) {
  const NumberColumn& column = *use.column;
  const std::string& cell = row.cells[use.cell];
  const auto number = csv_number<double>(cell);
  if (!number) {
    mistakes.add(row.line, use.name, '\'' + cell + '\'', "a number");
    return;
  }
  const double usual = use.unit == column.unit ? *number : *number * use.unit / column.unit;
  if (usual > column.highest && std::abs(usual) > 360.0)
    outside.push_back({row.line, use.name, cell,
                       fmt::format("at most {:g} {}: is the decimal point missing?", column.highest,
                                   column.unit_name),
                       false});
  else if (usual < column.lowest || usual > column.highest)
    outside.push_back({row.line, use.name, cell, std::string(column.expected), usual < 0.0});
  else
    cutter.*column.member = *number * use.unit;
}

/// Checks that chamfer, table and length are consistent with each other.
void check_sizes(const Cutter& c, CsvMistakes& mistakes) {
  const auto too_large = [&](const char* column, double size, double limit, const char* what) {
    if (size >= limit)
      mistakes.add(c.line, column, fmt::format("{:g}", 1e3 * size),
                   fmt::format("less than the cutter's {}, {:g}", what, 1e3 * limit));
  };
  too_large(c.land > 0.0 ? "land_mm" : "chamfer_mm", c.chamfer + c.land, 0.5 * c.diameter,
            "radius");
  too_large("wear_mm", c.wear, 0.5 * c.diameter, "radius");
  too_large("table_mm", c.table_thickness, c.length, "length");
  too_large("chamfer_deg", chamfer_depth(c), c.length, "length in depth");
  if (c.land > 0.0 && (c.chamfer == 0.0 || c.land_angle <= c.chamfer_angle))
    mistakes.add(c.line, "land_deg", fmt::format("{:g}", c.land_angle / degree),
                 fmt::format("a land flatter than its chamfer: more than {:g}",
                             c.chamfer == 0.0 ? 90.0 : c.chamfer_angle / degree));
}

Cutter read_cutter(const CsvRow& row, const CutterColumns& columns, const CutterDefaults& d,
                   std::vector<OutOfRange>& outside, CsvMistakes& mistakes) {
  Cutter c;
  c.line = static_cast<int>(row.line);
  take_shape(c, d);
  c.zone = row.cells[columns.labels.at("zone")];
  const auto count = [&] { return mistakes.lines.size() + outside.size(); };
  const auto before = count();
  read_integer(row, columns, "cutter", c.id, mistakes);
  read_integer(row, columns, "blade", c.blade, mistakes);
  for (const CutterColumns::Number& use : columns.numbers)
    read_number(row, use, c, outside, mistakes);
  if (count() == before) check_sizes(c, mistakes);
  c.X_BC = cutter_pose(c);
  return c;
}

void check_duplicates(const std::vector<Cutter>& cutters, CsvMistakes& mistakes) {
  std::map<int, int> line_of_number;
  std::map<std::tuple<double, double, double>, int> line_of_place;
  for (const Cutter& c : cutters) {
    const auto number = line_of_number.emplace(c.id, c.line);
    if (!number.second)
      mistakes.add(c.line, "cutter", fmt::format("{}, as in line {}", c.id, number.first->second),
                   "a number of its own");
    const auto place =
        line_of_place.emplace(std::tuple(c.tip_radius, c.azimuth, c.tip_height), c.line);
    if (!place.second)
      mistakes.add(c.line, "r_tip_mm, phi_deg, h_tip_mm",
                   fmt::format("the tip of line {}", place.first->second), "a tip of its own");
  }
}

/// The shortest number whose product with `unit` is x, as text: "-15", not "-14.999999999999998".
/// If none gives exactly x, the nearest one.
std::string cell(double x, double unit) {
  constexpr double most = std::numeric_limits<double>::max();
  constexpr int digits = std::numeric_limits<double>::max_digits10;
  const double value = x / unit;
  for (int n = 1; n < digits; ++n) {
    const std::string text = fmt::format("{:.{}g}", value, n);
    if (const auto read = csv_number<double>(text); read && *read * unit == x)
      return fmt::format("{}", *read);
  }
  for (const double v : {value, std::nextafter(value, most), std::nextafter(value, -most)})
    if (v * unit == x) return fmt::format("{}", v);
  return fmt::format("{}", value);
}

/// Records a header whose columns have another separator than commas, semicolons and tabs.
void check_separator(const CsvRow& header, CsvMistakes& mistakes) {
  if (header.cells.size() != 1) return;
  const std::string& all = header.cells.front();
  const std::pair<char, const char*> others[] = {{'|', "'|'"}, {':', "':'"}, {' ', "a space"}};
  for (const auto& [other, name] : others)
    if (std::ranges::count(all, other) > 1)
      return mistakes.add(header.line, "table",
                          fmt::format("one column, with {} in its name", name),
                          fmt::format("columns with a separator: a comma, a semicolon or a tab "
                                      "instead of {}",
                                      name));
}

/// What a row with too many or too few cells probably has.
std::string cells_found(const CsvRow& row, std::size_t expected) {
  const std::size_t n = row.cells.size();
  const bool commas = n > expected && n <= 2 * expected;
  return fmt::format("{} cells{}", n,
                     commas ? " (decimal commas? Then separate the columns with semicolons)" : "");
}

}  // namespace

void take_shape(Cutter& c, const CutterDefaults& d) {
  c.chamfer = d.chamfer;
  c.chamfer_angle = d.chamfer_angle;
  c.length = d.length;
  c.table_thickness = d.table_thickness;
  c.land = d.land;
  c.land_angle = d.land_angle;
}

std::vector<Cutter> read_cutter_table(const std::string& csv_path, const CutterDefaults& d) {
  const std::vector<CsvRow> rows = read_csv_rows(csv_path);
  CsvMistakes mistakes{csv_path};
  if (rows.size() < 2) mistakes.add(1, "table", "no cutter", "a header and at least one cutter");
  if (!rows.empty()) check_separator(rows.front(), mistakes);
  mistakes.throw_if_any();
  const CutterColumns columns = read_cutter_columns(rows.front(), mistakes);
  mistakes.throw_if_any();
  std::vector<Cutter> cutters;
  std::vector<OutOfRange> outside;
  const std::size_t width = rows.front().cells.size();
  for (const CsvRow& row : rows) {
    if (&row == &rows.front()) continue;
    if (row.cells.size() == width)
      cutters.push_back(read_cutter(row, columns, d, outside, mistakes));
    else
      mistakes.add(row.line, "row", cells_found(row, width),
                   fmt::format("{}, as in the header", width));
  }
  add_out_of_range(outside, mistakes);
  check_duplicates(cutters, mistakes);
  mistakes.throw_if_any();
  return cutters;
}

void round_to_table(Cutter& c) {
  for (const NumberColumn& column : number_columns())
    c.*column.member = c.*column.member / column.unit * column.unit;
}

std::string cutter_table_text(const std::string& bit, const std::vector<Cutter>& cutters) {
  std::string text = "bit,cutter,blade,zone";
  for (const NumberColumn& column : number_columns()) text += "," + column.name();
  text += '\n';
  for (const Cutter& c : cutters) {
    text += fmt::format("{},{},{},{}", bit, c.id, c.blade, c.zone);
    for (const NumberColumn& column : number_columns())
      text += fmt::format(",{}", cell(c.*column.member, column.unit));
    text += '\n';
  }
  return text;
}

}  // namespace tdbd::bit
