#include "reference/literature/roller/bands/band_cone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/roller/bracketed_root.hpp"

namespace tdbd::reference {
namespace {

/// v.n around a row, a + b cos g + c sin g. The rotation of the cone does not contribute.
struct EnteringSpeed {
  double a, b, c;
};

EnteringSpeed entering_speed(const RollerCone& cone, const RollerRow& row, const BandMotion& motion,
                             double half_angle) {
  const double cb = std::cos(cone.journal_angle), sb = std::sin(cone.journal_angle);
  const double ca = std::cos(half_angle), sa = std::sin(half_angle);
  const double sideways = motion.bit_speed * cone.offset;
  return {sa * (motion.rate * sb + sideways * cb), ca * (motion.rate * cb - sideways * sb),
          motion.bit_speed * cb * (row.along * ca + row.radius * sa)};
}

double band_width(const RollerRow& row, const BandOptions& options) {
  return options.width > 0.0 ? options.width : 2.0 * row.tooth_radius;
}

/// The row's share of the volume rate: that of a ring of the bottom with the projected width of the
/// band.
double share_of_volume(const RollerCone& cone, const RollerRow& row, const BandMotion& motion,
                       const BandOptions& options) {
  const double from_the_axis =
      row.along * std::cos(cone.journal_angle) + row.radius * std::sin(cone.journal_angle);
  return motion.rate * 2.0 * std::numbers::pi * from_the_axis * band_width(row, options) *
         std::cos(cone.journal_angle - options.half_angle) / static_cast<double>(motion.cones);
}

void add_loads(const BandStrip& s, const BandRock& rock, double cone_speed, BandLoads& sum) {
  constexpr double no_direction = 1e-12;
  const Vec3 velocity = s.velocity + cone_speed * s.spin;
  const double speed = velocity.norm();
  const Vec3 along = velocity / speed;
  const Vec3 across = s.normal - s.normal.dot(along) * along;
  const Vec3 direction = along + rock.normal_ratio / std::max(across.norm(), no_direction) * across;
  const Vec3 force = -rock.specific_energy * s.entering / speed * s.area * direction;
  sum.force += force;
  sum.torque += s.place.x() * force.y() - s.place.y() * force.x();
  sum.moment += s.spin.dot(force);
  sum.volume_rate += s.entering * s.area;
}

BandStrip strip_at(const RollerCone& cone, const JournalAxes& axes, const RollerRow& row,
                   double angle, const BandMotion& motion, const BandOptions& options) {
  const Vec3 outwards = std::cos(angle) * axes.u + std::sin(angle) * Vec3::UnitY();
  BandStrip s;
  s.place = Vec3(0.0, cone.offset, 0.0) - row.along * axes.s + row.radius * outwards;
  s.normal = std::cos(options.half_angle) * outwards + std::sin(options.half_angle) * axes.s;
  s.spin = row.radius * axes.s.cross(outwards);
  s.velocity = Vec3(-motion.bit_speed * s.place.y(), motion.bit_speed * s.place.x(), motion.rate);
  s.entering = s.velocity.dot(s.normal);
  return s;
}

}  // namespace

BandArc band_arc(const RollerCone& cone, const RollerRow& row, const BandMotion& motion,
                 const BandOptions& options) {
  const EnteringSpeed v = entering_speed(cone, row, motion, options.half_angle);
  const double size = std::hypot(v.b, v.c), phase = std::atan2(v.b, v.c);
  if (!(std::abs(v.a) < size))
    throw InputError(fmt::format(
        "Sheppard and Lesage: found a row at {:.6g} m along the journal and {:.6g} m from it that "
        "never leaves the rock, expected one that rolls into it",
        row.along, row.radius));
  const double rise = std::asin(-v.a / size), entry = rise - phase;
  const double wanted =
      share_of_volume(cone, row, motion, options) / (row.radius * band_width(row, options));
  const auto removed = [&](double g) {
    return v.a * (g - entry) + v.b * (std::sin(g) - std::sin(entry)) -
           v.c * (std::cos(g) - std::cos(entry));
  };
  const double last = std::numbers::pi - rise - phase;
  const auto root = bracketed_root(
      [&](double g) { return removed(g) - wanted; },
      {.low = entry, .high = last, .what = "Sheppard and Lesage: the end of a row's arc (rad)"});
  return {entry, root.x};
}

void lay_strips(const RollerCone& cone, const BandMotion& motion, const BandOptions& options,
                std::vector<BandStrip>& strips) {
  const JournalAxes axes = journal_axes(cone);
  strips.clear();
  for (std::size_t r = 0; r < cone.rows.size(); ++r) {
    const RollerRow& row = cone.rows[r];
    const BandArc arc = band_arc(cone, row, motion, options);
    const double step = (arc.exit - arc.entry) / options.angles;
    for (int i = 0; i < options.angles; ++i) {
      BandStrip s = strip_at(cone, axes, row, arc.entry + (i + 0.5) * step, motion, options);
      s.area = row.radius * band_width(row, options) * step;
      s.row = r;
      strips.push_back(s);
    }
  }
}

BandLoads band_loads(const std::vector<BandStrip>& strips, const BandRock& rock,
                     double cone_speed) {
  BandLoads sum;
  for (const BandStrip& s : strips) add_loads(s, rock, cone_speed, sum);
  return sum;
}

BandLoads row_loads(const std::vector<BandStrip>& strips, const BandRock& rock, double cone_speed,
                    std::size_t row) {
  BandLoads sum;
  for (const BandStrip& s : strips)
    if (s.row == row) add_loads(s, rock, cone_speed, sum);
  return sum;
}

}  // namespace tdbd::reference
