#include "reference/compare/models/roller_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "forces/law.hpp"
#include "reference/literature/roller/teeth/ma_azar.hpp"

namespace tdbd::reference {
namespace {

constexpr int table_rows = 61;

const forces::Indentation& tooth_law_of(const CompareCase& c, const std::string& model) {
  const auto* law =
      std::get_if<forces::Indentation>(&simulation::law_of(c.ours.forces, bit::PartKind::tooth));
  if (law == nullptr)
    throw InputError(fmt::format(
        "{}: found teeth under another law, needs forces.law = \"indentation\"", model));
  return *law;
}

}  // namespace

std::string row_name(const std::string& cone, std::size_t row) {
  return fmt::format("{}/row-{}", cone, row + 1);
}

double ring_radius(const RollerCone& cone, const RollerRow& row) {
  const double out =
      row.along * std::cos(cone.journal_angle) + row.radius * std::sin(cone.journal_angle);
  return std::hypot(out, cone.offset);
}

double largest_tooth(const RollerBit& bit) {
  double largest = 0.0;
  for (const RollerCone& cone : bit.cones)
    for (const RollerRow& row : cone.rows) largest = std::max(largest, row.tooth_radius);
  return largest;
}

double outer_rolling_ratio(const RollerBit& bit) {
  double outermost = 0.0, ratio = 0.0;
  for (const RollerCone& cone : bit.cones)
    for (const RollerRow& row : cone.rows)
      if (const double r = ring_radius(cone, row); r > outermost) {
        outermost = r;
        ratio = rolling_ratio(cone, row);
      }
  return ratio;
}

double tooth_pressure(const CompareCase& c, const std::string& model) {
  return tooth_law_of(c, model).ratio * c.ours.forces.rock.strengths.front().confined;
}

double tooth_friction(const CompareCase& c, const std::string& model) {
  return tooth_law_of(c, model).mu;
}

ToothTable tooth_table_of(const CompareCase& c, const RollerBit& bit, const std::string& model) {
  if (!c.options.roller.tooth_table.empty())
    return read_tooth_table(c.options.roller.tooth_table, model);
  const double pressure = tooth_pressure(c, model);
  const double a = largest_tooth(bit);
  ToothTable table;
  table.source = "a sphere under the law of indentation";
  for (int i = 0; i < table_rows; ++i) {
    const double depth = a * i / (table_rows - 1.0), square = 2.0 * a * depth - depth * depth;
    table.depth.push_back(depth);
    table.force.push_back(pressure * std::numbers::pi * square);
    table.radius.push_back(std::sqrt(square));
  }
  check_tooth_law(table, model);
  return table;
}

}  // namespace tdbd::reference
