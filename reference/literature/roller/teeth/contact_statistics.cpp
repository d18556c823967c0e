#include "reference/literature/roller/teeth/contact_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double equal_spacing = 1e-9;  // rad

/// Whether every tooth is, up to rounding, at a place of an equally spaced row, with angles in any
/// order.
bool evenly_spaced(const RollerRow& row) {
  const auto n = static_cast<double>(row.angles.size());
  const double pitch = 2.0 * half_turn / n;
  std::vector<bool> taken(row.angles.size(), false);
  for (const double angle : row.angles) {
    const double steps = (angle - row.angles.front()) / pitch, whole = std::round(steps);
    if (std::abs(steps - whole) * pitch > equal_spacing) return false;
    const double place = whole - n * std::floor(whole / n);
    taken[static_cast<std::size_t>(place)] = true;
  }
  return std::ranges::all_of(taken, [](bool t) { return t; });
}

void need_an_even_row(const RollerRow& row) {
  if (row.angles.empty())
    throw InputError("Ma and Azar: found a row without teeth, expected at least one");
  if (!evenly_spaced(row))
    throw InputError("Ma and Azar: found a row of " + std::to_string(row.angles.size()) +
                     " teeth of several pitches, expected teeth at equal angles");
  if (!(row.radius > 0.0))
    throw InputError("Ma and Azar: found a row on its journal, expected one around it");
}

}  // namespace

RowContact row_contact(const RollerCone& cone, const RollerRow& row, const RowEntry& entry) {
  need_an_even_row(row);
  if (!std::isfinite(entry.penetration))
    throw InputError("Ma and Azar: found a penetration that is not finite, expected metres");
  const double height = row.radius * std::cos(cone.journal_angle);
  RowContact contact;
  contact.half_angle = std::acos(std::clamp(1.0 - entry.penetration / height, -1.0, 1.0));
  contact.share = contact.half_angle / half_turn;
  const double speed = std::abs(entry.ratio * entry.bit_speed);
  contact.duration = speed > 0.0 ? 2.0 * contact.half_angle / speed : 0.0;
  const auto teeth = static_cast<double>(row.angles.size());
  contact.mean = teeth * contact.share;
  const double fraction = contact.mean - std::floor(contact.mean);
  contact.variance = fraction * (1.0 - fraction);
  contact.impressions = teeth * std::abs(entry.ratio);
  return contact;
}

ContactStatistics together(const std::vector<RowContact>& rows) {
  ContactStatistics sum;
  for (const RowContact& row : rows) {
    sum.mean += row.mean;
    sum.variance += row.variance;
  }
  return sum;
}

BitContact bit_contact(const RollerBit& bit, const std::vector<double>& ratios, double bit_speed,
                       double penetration) {
  require_equal_cones(bit);
  if (ratios.size() != bit.cones.size())
    throw InputError(
        fmt::format("Ma and Azar: found {} cone speeds, expected one for each of {} cones",
                    ratios.size(), bit.cones.size()));
  BitContact contact;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (const RollerRow& row : bit.cones[k].rows)
      contact.rows.push_back(row_contact(bit.cones[k], row, {penetration, ratios[k], bit_speed}));
  contact.all = together(contact.rows);
  return contact;
}

void require_equal_cones(const RollerBit& bit) {
  constexpr double same_height = 1e-9;  // m
  if (bit.cones.empty())
    throw InputError("Ma and Azar: found a bit without cones, expected a roller cone bit");
  const RollerCone& first = bit.cones.front();
  const double step = 2.0 * half_turn / static_cast<double>(bit.cones.size());
  for (std::size_t k = 1; k < bit.cones.size(); ++k) {
    const RollerCone& cone = bit.cones[k];
    const double off = cone.azimuth - first.azimuth - static_cast<double>(k) * step;
    if (std::abs(std::remainder(off, 2.0 * half_turn)) > equal_spacing)
      throw InputError(fmt::format(
          "Ma and Azar: found cone {} {:.6g} rad off its place, expected cones at equal angles",
          k + 1, std::remainder(off, 2.0 * half_turn)));
    if (std::abs(cone.elevation - first.elevation) > same_height)
      throw InputError(fmt::format(
          "Ma and Azar: found cone {} {:.6g} m below the first, expected all at one elevation",
          k + 1, cone.elevation - first.elevation));
  }
}

double print_offset(double impressions, double turned, double shift) {
  const double pitches = shift - impressions * turned;
  return std::abs(pitches - std::round(pitches));
}

bool tracks(double impressions, double turned, double shift, double tolerance) {
  return print_offset(impressions, turned, shift) <= tolerance;
}

}  // namespace tdbd::reference
