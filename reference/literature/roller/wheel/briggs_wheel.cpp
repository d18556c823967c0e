#include "reference/literature/roller/wheel/briggs_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "reference/literature/roller/bracketed_root.hpp"

namespace tdbd::reference {
namespace {

constexpr double wheel_pi = std::numbers::pi;

/// Constants of a rolling wheel. Depths from the rock's surface, distances from the start.
struct SprocketTrack {
  const Sprocket& wheel;
  double penetration = 0.0, rolling_radius = 0.0, column = 0.0;
  double pitch_angle = 0.0;    // rad
  double contact_angle = 0.0;  // rad, from the lowest tip to one that enters
  double flank = 0.0;          // m, from a tip to the intersection with the next flank
  double start = 0.0;          // m, place of the first column
};

/// One flank at one time, from the tip inwards.
struct SprocketFlank {
  double tip_x = 0.0, tip_depth = 0.0;  // m
  double run = 0.0, rise = 0.0;         // unit vector inwards: forward, up
};

struct SprocketContact {
  double load = 0.0, drag = 0.0, torque = 0.0;  // over pressure and width: m, m, m2
  double removed = 0.0;                         // m2
};

/// Lowers the rock to a flank and adds the load on its columns. `axle`: m, position of the wheel.
void press_flank(const SprocketTrack& track, const SprocketFlank& f, double axle,
                 std::vector<double>& profile, SprocketContact& sum) {
  // A flank that rises inwards leaves the rock; one that does not (of a front tooth) may enter it.
  const double in_rock = f.rise > 0.0 ? std::min(track.flank, f.tip_depth / f.rise) : track.flank;
  if (in_rock <= 0.0) return;
  const double end = f.tip_x + f.run * in_rock;
  const double left = std::min(f.tip_x, end), right = std::max(f.tip_x, end);
  const auto index = [&](double x) {
    return static_cast<std::size_t>(std::ceil((x - track.start) / track.column - 0.5));
  };
  const std::size_t last = index(right);
  const double slope = f.rise / f.run;
  double columns = 0.0, sum_x = 0.0, sum_depth = 0.0;
  for (std::size_t k = index(left); k < last; ++k) {
    const double x = track.start + (static_cast<double>(k) + 0.5) * track.column;
    const double depth = f.tip_depth - (x - f.tip_x) * slope;
    if (depth <= profile[k]) continue;
    columns += 1.0;
    sum_x += x - axle;
    sum_depth += depth;
    sum.removed += (depth - profile[k]) * track.column;
    profile[k] = depth;
  }
  if (columns == 0.0) return;
  // On a column's piece of a flank, the pressure sums to `column` upwards and to its rise forward.
  const double forward = slope * track.column;
  sum.load += columns * track.column;
  sum.drag += columns * forward;
  // of the axle above the rock's surface
  const double above = track.wheel.radius - track.penetration;
  // Moment of the rock's force (-forward, up column) about the axle: in front, its load slows the
  // wheel.
  sum.torque += (sum_depth + columns * above) * forward - sum_x * track.column;
}

/// All teeth near the rock, with the wheel rotated by `turned` and its axle at `axle`.
SprocketContact press_teeth(const SprocketTrack& t, double turned, double axle,
                            std::vector<double>& profile) {
  const double b = t.wheel.half_angle, reach = t.contact_angle + t.pitch_angle;
  SprocketContact sum;
  const auto first = static_cast<long>(std::ceil((turned - reach) / t.pitch_angle));
  const auto last = static_cast<long>(std::floor((turned + reach) / t.pitch_angle));
  for (long i = first; i <= last; ++i) {
    const double ahead = static_cast<double>(i) * t.pitch_angle - turned;
    const double x = axle + t.wheel.radius * std::sin(ahead);
    const double depth = t.wheel.radius * std::cos(ahead) - t.wheel.radius + t.penetration;
    press_flank(t, {x, depth, std::sin(b - ahead), std::cos(b - ahead)}, axle, profile, sum);
    press_flank(t, {x, depth, -std::sin(b + ahead), std::cos(b + ahead)}, axle, profile, sum);
  }
  return sum;
}

void refuse_wheel(bool bad, const std::string& found) {
  if (bad) throw InputError("Briggs: found " + found);
}

SprocketTrack checked_sprocket_track(const Sprocket& wheel, double penetration,
                                     double rolling_radius, const RollingOptions& options) {
  refuse_wheel(wheel.teeth < 3,
               "a wheel of " + std::to_string(wheel.teeth) + " teeth, expected at least 3");
  refuse_wheel(!(penetration > 0.0 && penetration < wheel.radius),
               "a penetration of " + std::to_string(penetration) +
                   " m, expected one between 0 and the wheel's radius");
  refuse_wheel(!(rolling_radius > 0.0 && options.column > 0.0 && options.step > 0.0),
               "a rolling radius, column or step that is not above 0");
  refuse_wheel(penetration < least_columns * options.column,
               "a penetration of " + std::to_string(penetration) + " m, expected at least " +
                   std::to_string(least_columns) + " columns of the rock's profile");
  SprocketTrack t{wheel, penetration, rolling_radius, options.column};
  t.pitch_angle = 2.0 * wheel_pi / wheel.teeth;
  t.contact_angle = std::acos(1.0 - penetration / wheel.radius);
  refuse_wheel(!(wheel.half_angle > t.contact_angle),
               "teeth of half-angle " + std::to_string(wheel.half_angle) +
                   " rad, expected more than the arc in the rock, " +
                   std::to_string(t.contact_angle) + " rad: sharper teeth undercut");
  const double polygon = 0.5 * (wheel_pi - t.pitch_angle), rounding = 1e-9;  // rad
  refuse_wheel(!(wheel.half_angle <= polygon + rounding),
               "teeth of half-angle " + std::to_string(wheel.half_angle) +
                   " rad, expected at most that of a polygon's corners, " +
                   std::to_string(polygon) + " rad");
  t.flank = wheel.radius * std::sin(0.5 * t.pitch_angle) /
            std::sin(wheel.half_angle + 0.5 * t.pitch_angle);
  t.start = -wheel.radius;
  return t;
}

/// Sets all values to zero and keeps the memory of the arrays.
void clear_rolling(Rolling& result) {
  Rolling fresh;
  std::swap(fresh.loads, result.loads);
  std::swap(fresh.drags, result.drags);
  std::swap(fresh.profile, result.profile);
  fresh.loads.clear();
  fresh.drags.clear();
  result = std::move(fresh);
}

void add_rolling_step(const SprocketContact& c, double pressure_width, Rolling& result) {
  result.loads.push_back(pressure_width * c.load);
  result.drags.push_back(pressure_width * c.drag);
  result.load += result.loads.back();
  result.drag += result.drags.back();
  result.axle_torque += pressure_width * c.torque;
  result.removed_area += c.removed;
}

void take_rolling_means(Rolling& result) {
  const double steps = static_cast<double>(result.loads.size());
  result.load /= steps;
  result.drag /= steps;
  result.axle_torque /= steps;
  const auto [least, most] = std::minmax_element(result.loads.begin(), result.loads.end());
  result.least_load = *least;
  result.most_load = *most;
}

}  // namespace

Sprocket smooth_wheel(double radius, int sides, double width) {
  return {radius, sides, wheel_pi / 2.0 - wheel_pi / sides, width};
}

void roll(const Sprocket& wheel, double pressure, double penetration, double rolling_radius,
          const RollingOptions& options, Rolling& result) {
  const SprocketTrack t = checked_sprocket_track(wheel, penetration, rolling_radius, options);
  const double pitch = rolling_radius * t.pitch_angle;
  const auto pitches = [&](double way) {
    return std::max(1, static_cast<int>(std::ceil(way / pitch)));
  };
  const int steps = std::max(4, static_cast<int>(std::ceil(pitch / options.step)));
  const int before = pitches(2.0 * wheel.radius * std::sin(t.contact_angle)) + 1;
  const int measured = pitches(options.distance);
  clear_rolling(result);
  const double way = (before + measured) * pitch + 2.0 * wheel.radius;
  result.profile.assign(static_cast<std::size_t>(std::ceil(way / t.column)) + 2, 0.0);
  for (int k = 0; k < (before + measured) * steps; ++k) {
    const double turned = k * t.pitch_angle / steps;
    const SprocketContact c = press_teeth(t, turned, rolling_radius * turned, result.profile);
    if (k >= before * steps) add_rolling_step(c, pressure * wheel.width, result);
  }
  result.distance = measured * pitch;
  result.angle = measured * t.pitch_angle;
  take_rolling_means(result);
}

double free_rolling_radius(const Sprocket& wheel, double penetration,
                           const RollingOptions& options) {
  constexpr double least = 0.9, most = 1.1, tolerance = 1e-5;  // relative to the radius
  Rolling r;
  const auto torque = [&](double rolling_radius) {
    roll(wheel, 1.0, penetration, rolling_radius, options, r);
    return r.axle_torque;
  };
  RootSearch search;
  search.low = least * wheel.radius;
  search.high = most * wheel.radius;
  search.relative = tolerance;
  search.what = "Briggs: a rolling radius (m) at which the wheel turns freely";
  return bracketed_root(torque, search).x;
}

}  // namespace tdbd::reference
