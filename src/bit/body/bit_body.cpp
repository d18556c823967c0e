#include "bit/body/bit_body.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bit/surface_of_revolution.hpp"

namespace tdbd::bit {
namespace {

constexpr int body_segments = 48;
constexpr double gage_length = 0.06;     ///< m, of full body above the highest tip
constexpr double shank_radius = 0.7;     ///< times the gage radius
constexpr double shank_length = 1.0;     ///< times the gage radius
constexpr double least_ring_gap = 1e-3;  ///< m, between two points of the meridian

/// Cutters of the profile, without back-ups, from the axis to the gage.
std::vector<Cutter> along_profile(std::vector<Cutter> cutters) {
  if (std::ranges::count(cutters, 0.0, &Cutter::under_exposure) > 0)
    std::erase_if(cutters, [](const Cutter& c) { return c.under_exposure > 0.0; });
  std::ranges::sort(cutters, {},
                    [](const Cutter& c) { return std::tuple(c.tip_radius, c.tip_height); });
  return cutters;
}

/// A ring about the bit's axis: x of a Ring is z of the bit.
Ring set_back(const Cutter& c, double setback) {
  const double depth = setback * c.diameter;
  return {c.tip_radius - depth * std::sin(c.profile_angle),
          -c.tip_height - depth * std::cos(c.profile_angle), body_segments};
}

/// The meridian under the cutters. If the profile is flat at the axis, the first cutter's slope is
/// kept.
std::vector<Ring> face_meridian(const std::vector<Cutter>& ordered, double setback) {
  const Ring first = set_back(ordered.front(), setback);
  const double slope = std::tan(std::clamp(ordered.front().profile_angle, -0.8, 0.0));
  std::vector<Ring> rings{{0.0, first.x + slope * first.radius, 1}};
  for (const Cutter& c : ordered) {
    const Ring next = set_back(c, setback);
    if (std::hypot(next.radius - rings.back().radius, next.x - rings.back().x) > least_ring_gap &&
        next.radius >= rings.back().radius)
      rings.push_back(next);
  }
  return rings;
}

/// Rotates rings about X to rings about the bit's z. A cyclic exchange of axes preserves the
/// orientation.
mesh::TriangleMesh about_z(mesh::TriangleMesh m) {
  for (Vec3& p : m.positions) p = Vec3(p.y(), p.z(), p.x());
  return m;
}

}  // namespace

Part bit_body(const std::vector<Cutter>& cutters, double setback, double density,
              double gage_radius) {
  std::vector<Ring> rings = face_meridian(along_profile(cutters), setback);
  const double highest_tip = std::ranges::max(cutters, {}, &Cutter::tip_height).tip_height;
  const double shoulder = -highest_tip - gage_length;
  const double end = shoulder - shank_length * gage_radius;
  rings.push_back({rings.back().radius, shoulder, body_segments});
  rings.push_back({shank_radius * gage_radius, shoulder, body_segments});
  rings.push_back({shank_radius * gage_radius, end, body_segments});
  rings.push_back({0.0, end, 1});
  Part body;
  body.name = "bit-body";
  body.kind = PartKind::bit_body;
  body.cutting = Cutting::never;
  body.mesh_P = about_z(surface_of_revolution(rings));
  body.density = density;
  return body;
}

}  // namespace tdbd::bit
