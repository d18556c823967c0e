#include "reference/literature/roller/wheel/briggs_bit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "reference/literature/roller/bracketed_root.hpp"

namespace tdbd::reference {
namespace {

constexpr double briggs_tolerance = 1e-5;  // relative to the bracket

/// At smaller penetrations no tooth undercuts, and the wheel's axle stays above the rock.
double most_briggs_penetration(const Sprocket& wheel) {
  constexpr double inside = 0.999;
  return inside * wheel.radius * (1.0 - std::cos(std::min(wheel.half_angle, std::numbers::pi / 3)));
}

/// A freely rolling wheel under a pressure.
double roll_freely(const Sprocket& wheel, double pressure, double penetration,
                   const RollingOptions& options, Rolling& result) {
  const double radius = free_rolling_radius(wheel, penetration, options);
  roll(wheel, pressure, penetration, radius, options, result);
  return radius;
}

/// The penetration at which a quantity of the freely rolling wheel, which increases with it, has a
/// value.
template <typename Figure>
double briggs_penetration_for(const Sprocket& wheel, double pressure, double value,
                              const char* what, const RollingOptions& options,
                              const Figure& figure) {
  Rolling r;
  const auto excess = [&](double penetration) {
    roll_freely(wheel, pressure, penetration, options, r);
    return figure(r) - value;
  };
  const double low = least_columns * options.column, high = most_briggs_penetration(wheel);
  RootSearch search;
  search.low = low;
  search.high = high;
  search.relative = briggs_tolerance;
  search.what = "Briggs: a penetration (m) at which " + std::string(what);
  return bracketed_root(excess, search).x;
}

void briggs_needs(double rotary_speed, double value, const char* what) {
  if (!(rotary_speed > 0.0))
    throw InputError("Briggs: found no rotary speed, expected one above 0");
  if (!(value > 0.0))
    throw InputError(std::string("Briggs: found no ") + what + ", expected one above 0");
}

}  // namespace

BriggsBit briggs_bit(const RollerBit& bit, std::size_t cone, std::size_t row, double half_angle,
                     double width) {
  if (cone >= bit.cones.size() || row >= bit.cones[cone].rows.size())
    throw InputError("Briggs: found " + std::to_string(bit.cones.size()) + " cones and no row " +
                     std::to_string(row) + " on cone " + std::to_string(cone) +
                     ", expected a row of teeth");
  const RollerCone& c = bit.cones[cone];
  const RollerRow& r = c.rows[row];
  return {{r.radius, static_cast<int>(r.angles.size()), half_angle, width},
          static_cast<int>(bit.cones.size()),
          r.along * std::cos(c.journal_angle) + r.radius * std::sin(c.journal_angle)};
}

BriggsDrilling briggs_at_penetration(const BriggsBit& bit, const CoulombRock& rock,
                                     double penetration, double rotary_speed,
                                     const RollingOptions& options) {
  briggs_needs(rotary_speed, bit.track_radius, "radius of the wheels' track");
  BriggsDrilling d;
  d.penetration = penetration;
  d.rolling_radius = roll_freely(bit.wheel, wedge_pressure(rock, bit.wheel.half_angle), penetration,
                                 options, d.wheel);
  d.cone_ratio = bit.track_radius / d.rolling_radius;
  d.weight = bit.wheels * d.wheel.load;
  d.torque = bit.wheels * d.wheel.drag * bit.track_radius;
  d.advance = bit.wheels * d.wheel.removed_height();
  d.rate = d.advance * rotary_speed / (2.0 * std::numbers::pi);
  return d;
}

BriggsDrilling briggs_under_weight(const BriggsBit& bit, const CoulombRock& rock, double weight,
                                   double rotary_speed, const RollingOptions& options) {
  briggs_needs(rotary_speed, weight, "weight");
  const double penetration = briggs_penetration_for(
      bit.wheel, wedge_pressure(rock, bit.wheel.half_angle), weight / bit.wheels,
      "its wheels carry the weight", options, [](const Rolling& r) { return r.load; });
  return briggs_at_penetration(bit, rock, penetration, rotary_speed, options);
}

double briggs_cohesion(const BriggsBit& bit, double friction_angle, double weight, double rate,
                       double rotary_speed, const RollingOptions& options) {
  briggs_needs(rotary_speed, weight, "weight");
  const double height = rate * 2.0 * std::numbers::pi / rotary_speed / bit.wheels;
  const double penetration =
      briggs_penetration_for(bit.wheel, 1.0, height, "the bit has the rate", options,
                             [](const Rolling& r) { return r.removed_height(); });
  Rolling r;
  roll_freely(bit.wheel, 1.0, penetration, options, r);
  return wedge_cohesion(weight / bit.wheels / r.load, friction_angle, bit.wheel.half_angle);
}

}  // namespace tdbd::reference
