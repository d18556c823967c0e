#include "reference/literature/roller/contact_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double equal_spacing = 1e-9;  // rad

/// Every tooth within rounding of its place in an even row, in any order of the angles.
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

double print_offset(double impressions, double turned, double shift) {
  const double pitches = shift - impressions * turned;
  return std::abs(pitches - std::round(pitches));
}

bool tracks(double impressions, double turned, double shift, double tolerance) {
  return print_offset(impressions, turned, shift) <= tolerance;
}

}  // namespace tdbd::reference
