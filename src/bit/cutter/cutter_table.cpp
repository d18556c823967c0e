#include "bit/cutter/cutter_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "bit/cutter/cutter.hpp"
#include "core/config/csv.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

/// A column that contains a number: its destination, unit and valid range. Bounds are in the
/// column's own unit.
struct NumberColumn {
  std::string_view name;
  double Cutter::*member;
  double unit;  ///< SI per unit of the column
  bool required;
  double lowest, highest;
  std::string_view expected;  ///< the bounds in words, for messages
};

constexpr double mm = 1e-3;
constexpr double tiny = 1e-6;  ///< lower bound of "positive": more than a nanometre, in mm
constexpr double large = 1e4;  ///< mm: no bit is 10 m wide

constexpr std::array<NumberColumn, 15> number_columns{{
    {"dia_mm", &Cutter::diameter, mm, true, tiny, large, "a positive diameter"},
    {"r_tip_mm", &Cutter::tip_radius, mm, true, 0, large, "a radius >= 0"},
    {"phi_deg", &Cutter::azimuth, degree, true, -360, 360, "an angle in -360..360"},
    {"h_tip_mm", &Cutter::tip_height, mm, true, -large, large, "a height"},
    {"profile_angle_deg", &Cutter::profile_angle, degree, true, -90, 100, "an angle in -90..100"},
    {"back_rake_deg", &Cutter::back_rake, degree, true, -5, 60, "an angle in -5..60"},
    {"side_rake_deg", &Cutter::side_rake, degree, true, -45, 45, "an angle in -45..45"},
    {"chamfer_mm", &Cutter::chamfer, mm, false, 0, large, "a width >= 0"},
    {"chamfer_deg", &Cutter::chamfer_angle, degree, false, 10, 80, "an angle in 10..80"},
    {"length_mm", &Cutter::length, mm, false, tiny, large, "a positive length"},
    {"table_mm", &Cutter::table_thickness, mm, false, tiny, large, "a positive thickness"},
    {"land_mm", &Cutter::land, mm, false, 0, large, "a width >= 0"},
    {"land_deg", &Cutter::land_angle, degree, false, 10, 85, "an angle in 10..85"},
    {"wear_mm", &Cutter::wear, mm, false, 0, large, "a height >= 0"},
    {"under_exposure_mm", &Cutter::under_exposure, mm, false, 0, large, "a depth >= 0"},
}};

constexpr std::array<std::string_view, 4> label_columns{"bit", "cutter", "blade", "zone"};

/// Column index by name.
using Header = std::map<std::string, int, std::less<>>;

bool is_known(std::string_view name) {
  return std::ranges::count(label_columns, name) +
             std::ranges::count(number_columns, name, &NumberColumn::name) >
         0;
}

Header read_header(const CsvRow& row, CsvMistakes& mistakes) {
  Header header;
  for (const std::string& name : row.cells) {
    const int cell = static_cast<int>(&name - row.cells.data());
    if (name.starts_with("exposure"))
      mistakes.add(row.line, name, "a column of exposures",
                   "under_exposure_mm here, exposure in the bit file's [blades]");
    else if (!is_known(name))
      mistakes.add(row.line, name, "an unknown column", "a known one");
    if (!header.emplace(name, cell).second)
      mistakes.add(row.line, name, "the column twice", "it once");
  }
  const auto need = [&](std::string_view name) {
    if (!header.contains(name)) mistakes.add(row.line, name, "no such column", "it in the header");
  };
  for (const std::string_view name : label_columns) need(name);
  for (const NumberColumn& c : number_columns)
    if (c.required) need(c.name);
  return header;
}

void read_integer(const CsvRow& row, const Header& header, std::string_view name, int& value,
                  CsvMistakes& mistakes) {
  const std::string& cell = row.cells[at(header.find(name)->second)];
  if (const auto number = csv_number<int>(cell))
    value = *number;
  else
    mistakes.add(row.line, name, '\'' + cell + '\'', "a whole number");
}

void read_number(const CsvRow& row, const Header& header, const NumberColumn& column,
                 Cutter& cutter, CsvMistakes& mistakes) {
  const auto place = header.find(column.name);
  if (place == header.end()) return;
  const std::string& cell = row.cells[at(place->second)];
  const auto number = csv_number<double>(cell);
  if (!number)
    mistakes.add(row.line, column.name, '\'' + cell + '\'', "a number");
  else if (*number < column.lowest || *number > column.highest)
    mistakes.add(row.line, column.name, cell, column.expected);
  else
    cutter.*column.member = *number * column.unit;
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

Cutter read_cutter(const CsvRow& row, const Header& header, const CutterDefaults& d,
                   CsvMistakes& mistakes) {
  Cutter c;
  c.line = static_cast<int>(row.line);
  take_shape(c, d);
  c.zone = row.cells[at(header.at("zone"))];
  const auto before = mistakes.lines.size();
  read_integer(row, header, "cutter", c.id, mistakes);
  read_integer(row, header, "blade", c.blade, mistakes);
  for (const NumberColumn& column : number_columns) read_number(row, header, column, c, mistakes);
  if (mistakes.lines.size() == before) check_sizes(c, mistakes);
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

/// The number that the reader converts to x: x / unit, or the adjacent double whose product with
/// `unit` is x.
double cell(double x, double unit) {
  constexpr double most = std::numeric_limits<double>::max();
  const double value = x / unit;
  for (const double v : {value, std::nextafter(value, most), std::nextafter(value, -most)})
    if (v * unit == x) return v;
  return value;
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
  mistakes.throw_if_any();
  const Header header = read_header(rows.front(), mistakes);
  mistakes.throw_if_any();
  std::vector<Cutter> cutters;
  for (const CsvRow& row : rows) {
    if (&row == &rows.front()) continue;
    if (row.cells.size() == rows.front().cells.size())
      cutters.push_back(read_cutter(row, header, d, mistakes));
    else
      mistakes.add(row.line, "row", fmt::format("{} cells", row.cells.size()),
                   fmt::format("{}, as in the header", rows.front().cells.size()));
  }
  check_duplicates(cutters, mistakes);
  mistakes.throw_if_any();
  return cutters;
}

void round_to_table(Cutter& c) {
  for (const NumberColumn& column : number_columns)
    c.*column.member = c.*column.member / column.unit * column.unit;
}

std::string cutter_table_text(const std::string& bit, const std::vector<Cutter>& cutters) {
  std::string text = "bit,cutter,blade,zone";
  for (const NumberColumn& column : number_columns) text += fmt::format(",{}", column.name);
  text += '\n';
  for (const Cutter& c : cutters) {
    text += fmt::format("{},{},{},{}", bit, c.id, c.blade, c.zone);
    for (const NumberColumn& column : number_columns)
      text += fmt::format(",{}", cell(c.*column.member, column.unit));
    text += '\n';
  }
  return text;
}

}  // namespace tdbd::bit
