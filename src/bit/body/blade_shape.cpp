#include "bit/body/blade_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "core/types.hpp"

namespace tdbd::bit {
namespace {

constexpr double least_spacing = 1e-3;    ///< m, between two nodes of the meridian
constexpr double margin = 2e-3;           ///< m, of a blade behind its cutters
constexpr double lead_diameters = 0.75;   ///< diameters of a blade before its first tip
constexpr double steepest_to_axis = 0.8;  ///< rad, of the profile extrapolated to the axis

HalfPlanePoint minus(const HalfPlanePoint& p, double depth, double angle) {
  return {p.r - depth * std::sin(angle), p.z - depth * std::cos(angle)};
}

HalfPlanePoint between(const HalfPlanePoint& a, const HalfPlanePoint& b, double w) {
  return {std::lerp(a.r, b.r, w), std::lerp(a.z, b.z, w)};
}

double distance(const HalfPlanePoint& a, const HalfPlanePoint& b) {
  return std::hypot(b.r - a.r, b.z - a.z);
}

/// A cutter's tip without its under-exposure.
HalfPlanePoint exposed_tip(const Cutter& c) {
  return minus({c.tip_radius, -c.tip_height}, -c.under_exposure, c.profile_angle);
}

std::vector<Cutter> face_cutters(std::vector<Cutter> cutters) {
  std::erase_if(cutters, [](const Cutter& c) { return c.under_exposure > 0.0; });
  std::ranges::sort(cutters, {}, [](const Cutter& c) {
    return std::tuple(c.tip_radius, c.tip_height, c.azimuth);
  });
  return cutters;
}

/// If the profile is flat at the axis, the meridian keeps the first cutter's slope.
MeridianNode on_axis(const MeridianNode& first, const Cutter& c, const BladeOptions& options) {
  const double slope = std::tan(std::clamp(c.profile_angle, -steepest_to_axis, 0.0));
  const double z = first.top.z + slope * first.top.r;
  return {0.0, {0.0, z}, {0.0, z - options.slot_depth}};
}

void add_meridian(const std::vector<Cutter>& face, const BladeOptions& options, BladeShape& shape) {
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Cutter& c = face[k];
    const HalfPlanePoint top = minus(shape.tips[k].second, options.exposure, c.profile_angle);
    const MeridianNode node{shape.tips[k].first, top,
                            minus(top, options.slot_depth, c.profile_angle)};
    if (shape.meridian.empty()) shape.meridian.push_back(on_axis(node, c, options));
    const HalfPlanePoint& last = shape.meridian.back().top;
    if (distance(last, top) > least_spacing && top.r >= last.r) shape.meridian.push_back(node);
  }
  MeridianNode end = shape.meridian.back();
  const double rise = options.gage_length + shape.tips.back().first - end.s;
  end.s += rise;
  end.top.z -= rise;
  end.floor = {end.top.r - options.slot_depth, end.top.z};
  shape.meridian.push_back(end);
}

/// The cutters' azimuths along the meridian, unwrapped.
std::vector<std::pair<double, double>> front_line(const BladeShape& shape,
                                                  const std::vector<Cutter>& cutters) {
  std::vector<std::pair<double, double>> line;
  line.reserve(cutters.size());
  for (const Cutter& c : cutters) line.emplace_back(place_of(shape, c), c.azimuth);
  std::ranges::sort(line);
  for (std::size_t k = 1; k < line.size(); ++k)
    line[k].second =
        line[k - 1].second + std::remainder(line[k].second - line[k - 1].second, full_turn);
  const double whole_turns = full_turn * std::floor(line.back().second / full_turn);
  for (auto& point : line) point.second -= whole_turns;
  return line;
}

/// Coordinate of a cutter's tip along its blade's front.
double along_front(const BladeStrip& blade, const Cutter& c, double s) {
  return c.tip_radius * std::cos(c.azimuth - front_at(blade, s));
}

BladeStrip strip_of(const BladeShape& shape, int number, const std::vector<Cutter>& all,
                    const BladeOptions& options) {
  std::vector<Cutter> leading = face_cutters(all);
  if (leading.empty()) leading = all;
  BladeStrip blade{number, front_line(shape, leading), options.width,
                   std::numeric_limits<double>::infinity()};
  for (const Cutter& c : leading)
    blade.start = std::min(blade.start,
                           along_front(blade, c, place_of(shape, c)) - lead_diameters * c.diameter);
  if (options.width > 0.0) return blade;
  for (const Cutter& c : all)
    blade.width = std::max(blade.width, trail_of(blade, c, place_of(shape, c)) + margin);
  return blade;
}

/// Distance from a strip divided by the width of a wall: 0 on the strip, 1 at the end of the wall.
double beside(const BladeStrip& blade, double wall, double r, double ahead) {
  const double x = r * std::cos(ahead), y = r * std::sin(ahead);
  return std::max({y, -blade.width - y, blade.start - x, 0.0}) / wall;
}

}  // namespace

BladeShape blade_shape(const std::vector<Cutter>& cutters, const BladeOptions& options) {
  BladeShape shape;
  shape.wall = options.wall;
  std::vector<Cutter> face = face_cutters(cutters);
  if (face.empty()) face = cutters;
  double s = face.front().tip_radius /
             std::cos(std::clamp(face.front().profile_angle, -steepest_to_axis, steepest_to_axis));
  for (const Cutter& c : face) {
    const HalfPlanePoint tip = exposed_tip(c);
    if (!shape.tips.empty()) s += distance(shape.tips.back().second, tip);
    shape.tips.emplace_back(s, tip);
  }
  add_meridian(face, options, shape);
  std::map<int, std::vector<Cutter>> by_blade;
  for (const Cutter& c : cutters) by_blade[c.blade].push_back(c);
  for (const auto& [number, of_blade] : by_blade)
    shape.blades.push_back(strip_of(shape, number, of_blade, options));
  std::ranges::sort(shape.blades, {}, [](const BladeStrip& b) { return b.front.back().second; });
  return shape;
}

MeridianNode meridian_at(const BladeShape& shape, double s) {
  const auto& nodes = shape.meridian;
  std::size_t k = 1;
  while (k + 1 < nodes.size() && nodes[k].s < s) ++k;
  const MeridianNode &a = nodes[k - 1], &b = nodes[k];
  const double w = std::clamp((s - a.s) / (b.s - a.s), 0.0, 1.0);
  return {s, between(a.top, b.top, w), between(a.floor, b.floor, w)};
}

double front_at(const BladeStrip& blade, double s) {
  const auto& line = blade.front;
  const auto after = std::ranges::lower_bound(line, s, {}, &std::pair<double, double>::first);
  if (after == line.begin()) return line.front().second;
  if (after == line.end()) return line.back().second;
  const auto& [s0, a0] = after[-1];
  return std::lerp(a0, after->second, (s - s0) / (after->first - s0));
}

double sunk_share(const BladeShape& shape, const MeridianNode& at, double azimuth) {
  double share = 1.0;
  for (const BladeStrip& blade : shape.blades)
    share = std::min(share, beside(blade, shape.wall, at.top.r, azimuth - front_at(blade, at.s)));
  return share;
}

Vec3 surface_point_B(const BladeShape& shape, const MeridianNode& at, double azimuth) {
  const HalfPlanePoint p = between(at.top, at.floor, sunk_share(shape, at, azimuth));
  return {p.r * std::cos(azimuth), p.r * std::sin(azimuth), p.z};
}

double trail_of(const BladeStrip& blade, const Cutter& c, double s) {
  const Vec3 end_B = c.X_BC * Vec3(-c.length, 0.0, 0.0);
  const double front = front_at(blade, s);
  return end_B.x() * std::sin(front) - end_B.y() * std::cos(front);
}

double place_of(const BladeShape& shape, const Cutter& c) {
  const HalfPlanePoint p = exposed_tip(c);
  double place = shape.tips.front().first, least = distance(shape.tips.front().second, p);
  for (std::size_t k = 1; k < shape.tips.size(); ++k) {
    const auto& [sa, a] = shape.tips[k - 1];
    const auto& [sb, b] = shape.tips[k];
    if (sb == sa) continue;
    const double along = ((p.r - a.r) * (b.r - a.r) + (p.z - a.z) * (b.z - a.z)) / (sb - sa);
    const double w = std::clamp(along / (sb - sa), 0.0, 1.0);
    const double gap = distance(between(a, b, w), p);
    if (gap < least) {
      least = gap;
      place = std::lerp(sa, sb, w);
    }
  }
  return place;
}

}  // namespace tdbd::bit
