#include "bit/cone/leg_clearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "bit/cone/cone_interference.hpp"
#include "bit/cone/meridian.hpp"
#include "bit/cone/meridian_gap.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

struct LegPatch {
  std::array<Vec3, 3> corners_K;
  double least;  ///< m, lower bound of the distance of the patch from the solid

  bool operator<(const LegPatch& p) const { return least > p.least; }  // smallest first
};

struct NearestPlace {
  double distance = std::numeric_limits<double>::infinity();
  Vec3 place_K = Vec3::Zero();
};

/// Measures the middle of a patch and bounds its other points: by the distance of its corners from
/// the middle, and by its distance along the journal from the whole solid, which is exact where a
/// leg is parallel to the base of its cone.
void measure(LegPatch& p, const Meridian& solid, NearestPlace& best) {
  const Vec3 middle = (p.corners_K[0] + p.corners_K[1] + p.corners_K[2]) / 3.0;
  const double distance = signed_distance(solid, {-middle.z(), std::hypot(middle.x(), middle.y())});
  if (distance < best.distance) best = {distance, middle};
  double extent = 0.0, s = std::numeric_limits<double>::infinity();
  for (const Vec3& x : p.corners_K) {
    extent = std::max(extent, (x - middle).norm());
    s = std::min(s, -x.z());
  }
  const double end = std::ranges::max(solid, {}, &ShellPoint::s).s;
  p.least = std::max(distance - extent, s - end);
}

/// Bisects the longest side of the patch.
std::array<LegPatch, 2> halves_of_patch(const LegPatch& p) {
  std::size_t from = 0;
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    if (const double side = (p.corners_K[(i + 1) % 3] - p.corners_K[i]).norm(); side > longest) {
      longest = side;
      from = i;
    }
  const std::size_t to = (from + 1) % 3;
  std::array<LegPatch, 2> both{p, p};
  both[0].corners_K[to] = both[1].corners_K[from] = 0.5 * (p.corners_K[from] + p.corners_K[to]);
  return both;
}

/// The place of a mesh that is nearest to a solid of revolution about z, or deepest in it. Stops
/// early if no distance is below `enough`, and then returns one at least that large.
NearestPlace nearest_place(const mesh::TriangleMesh& m, const Pose& X_KP, const Meridian& solid,
                           double enough) {
  NearestPlace best;
  std::priority_queue<LegPatch> patches;
  const auto add = [&](LegPatch p) {
    measure(p, solid, best);
    patches.push(p);
  };
  for (const mesh::Triangle& t : m.triangles) {
    LegPatch p{};
    for (std::size_t i = 0; i < 3; ++i)
      p.corners_K[i] = X_KP * m.positions[static_cast<std::size_t>(t[i])];
    add(p);
  }
  for (long looked_at = 0; !patches.empty(); ++looked_at) {
    const LegPatch p = patches.top();
    patches.pop();
    if (p.least >= best.distance - clearance_tolerance || p.least >= enough) break;
    if (looked_at == most_patches) {
      best.distance = p.least;
      break;
    }
    for (const LegPatch& half : halves_of_patch(p)) add(half);
  }
  return best;
}

void add_leg_pair(const Part& leg, const Cone& cone, std::vector<LegClearance>& all) {
  const Pose X_KP = inverse(cone.X_BK) * leg.X_BP;
  std::vector<LegClearance> clashes;
  LegClearance nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  for (const Turning& turning : turning_parts(cone)) {
    const NearestPlace at =
        nearest_place(leg.mesh_P, X_KP, turning.meridian, std::max(0.0, nearest.distance));
    const double angle =
        std::fmod(std::atan2(at.place_K.y(), at.place_K.x()) - turning.first_angle + 2 * full_turn,
                  full_turn);
    const LegClearance here{leg.name, turning.part, at.distance, angle, cone.X_BK * at.place_K};
    if (here.distance < 0.0) clashes.push_back(here);
    if (here.distance < nearest.distance) nearest = here;
  }
  if (clashes.empty()) clashes.push_back(nearest);
  all.insert(all.end(), clashes.begin(), clashes.end());
}

bool is_leg(const Part& part) {
  return part.kind == PartKind::bit_body && part.name.starts_with("leg-");
}

}  // namespace

std::vector<LegClearance> leg_clearances(const Bit& bit) {
  std::vector<LegClearance> all;
  for (const Part& part : bit.parts)
    for (const Cone& cone : bit.cones)
      if (is_leg(part) && !cone.layout.shell.empty()) add_leg_pair(part, cone, all);
  std::ranges::stable_sort(all, {}, &LegClearance::distance);
  return all;
}

std::string clearance_text(const LegClearance& c) {
  return fmt::format("{} of {:.3f} mm of {} and {} (at {:.1f} deg) at ({:.1f}, {:.1f}, {:.1f}) mm",
                     c.distance < 0.0 ? "an overlap" : "a gap", 1e3 * std::abs(c.distance), c.leg,
                     c.part, c.angle / degree, 1e3 * c.place_B.x(), 1e3 * c.place_B.y(),
                     1e3 * c.place_B.z());
}

}  // namespace tdbd::bit
