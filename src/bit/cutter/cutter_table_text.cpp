#include "bit/cutter/cutter_table_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "bit/cutter/cutter_columns.hpp"

namespace tdbd::bit {
namespace {

/// The number that the reader turns into x: x / unit, or the double beside it whose product is x.
double cell(double x, double unit) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double value = x / unit;
  for (const double v : {value, std::nextafter(value, infinity), std::nextafter(value, -infinity)})
    if (v * unit == x) return v;
  return value;
}

}  // namespace

std::string cutter_table_text(const std::string& bit, const std::vector<Cutter>& cutters) {
  std::string text = "bit,cutter,blade,zone";
  for (const NumberColumn& column : number_columns()) text += fmt::format(",{}", column.name);
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
