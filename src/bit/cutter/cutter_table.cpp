#include "bit/cutter/cutter_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

#include "bit/cutter/csv.hpp"
#include "bit/cutter/cutter_columns.hpp"
#include "bit/cutter/cutter_frame.hpp"
#include "core/error.hpp"

namespace tdbd::bit {
namespace {

constexpr std::array<std::string_view, 4> label_columns{"bit", "cutter", "blade", "zone"};

/// The file's mistakes so far, in the order of discovery.
struct Mistakes {
  std::string file;
  std::vector<std::string> lines;

  void add(int line, std::string_view column, std::string_view found, std::string_view expected) {
    lines.push_back(
        fmt::format("{}:{}: {}: found {}, expected {}", file, line, column, found, expected));
  }
  void throw_if_any() const {
    if (lines.empty()) return;
    std::string message = lines.front();
    for (std::size_t k = 1; k < lines.size(); ++k) message += '\n' + lines[k];
    throw InputError(message);
  }
};

/// Column name to cell number.
using Header = std::map<std::string, int, std::less<>>;

bool is_known(std::string_view name) {
  return std::ranges::count(label_columns, name) +
             std::ranges::count(number_columns(), name, &NumberColumn::name) >
         0;
}

Header read_header(const CsvRow& row, Mistakes& mistakes) {
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
  for (const NumberColumn& c : number_columns())
    if (c.required) need(c.name);
  return header;
}

/// The number that a cell holds; nothing when any character of it is not part of one finite number.
template <typename Number>
std::optional<Number> parsed(const std::string& cell) {
  Number value{};
  const char* end = cell.data() + cell.size();
  const auto [stop, status] = std::from_chars(cell.data(), end, value);
  if (status != std::errc() || stop != end || !std::isfinite(static_cast<double>(value))) return {};
  return value;
}

void read_integer(const CsvRow& row, const Header& header, std::string_view name, int& value,
                  Mistakes& mistakes) {
  const std::string& cell = row.cells[header.find(name)->second];
  if (const auto number = parsed<int>(cell))
    value = *number;
  else
    mistakes.add(row.line, name, '\'' + cell + '\'', "a whole number");
}

void read_number(const CsvRow& row, const Header& header, const NumberColumn& column,
                 Cutter& cutter, Mistakes& mistakes) {
  const auto place = header.find(column.name);
  if (place == header.end()) return;
  const std::string& cell = row.cells[place->second];
  const auto number = parsed<double>(cell);
  if (!number)
    mistakes.add(row.line, column.name, '\'' + cell + '\'', "a number");
  else if (*number < column.lowest || *number > column.highest)
    mistakes.add(row.line, column.name, cell, column.expected);
  else
    cutter.*column.member = *number * column.unit;
}

/// What one column alone cannot tell: whether chamfer, table and length fit into one another.
void check_sizes(const Cutter& c, Mistakes& mistakes) {
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
  constexpr double deg = std::numbers::pi / 180.0;
  if (c.land > 0.0 && (c.chamfer == 0.0 || c.land_angle <= c.chamfer_angle))
    mistakes.add(c.line, "land_deg", fmt::format("{:g}", c.land_angle / deg),
                 fmt::format("a land flatter than its chamfer: more than {:g}",
                             c.chamfer == 0.0 ? 90.0 : c.chamfer_angle / deg));
}

Cutter read_cutter(const CsvRow& row, const Header& header, const CutterDefaults& d,
                   Mistakes& mistakes) {
  Cutter c;
  c.line = row.line;
  take_shape(c, d);
  c.zone = row.cells[header.at("zone")];
  const auto before = mistakes.lines.size();
  read_integer(row, header, "cutter", c.id, mistakes);
  read_integer(row, header, "blade", c.blade, mistakes);
  for (const NumberColumn& column : number_columns()) read_number(row, header, column, c, mistakes);
  if (mistakes.lines.size() == before) check_sizes(c, mistakes);
  c.X_BC = cutter_pose(c);
  return c;
}

void check_duplicates(const std::vector<Cutter>& cutters, Mistakes& mistakes) {
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
  const std::vector<CsvRow> rows = read_csv(csv_path);
  Mistakes mistakes{csv_path, {}};
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

}  // namespace tdbd::bit
