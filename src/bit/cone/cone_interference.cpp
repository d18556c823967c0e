#include "bit/cone/cone_interference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "core/types.hpp"

namespace tdbd::bit {
namespace {

/// A patch of A's surface: a piece of one side of the meridian and an interval of angles.
struct Patch {
  std::size_t side;
  double along, half_along;  ///< in [0, 1] of the side
  double angle, half_angle;  ///< rad
  double least;              ///< m, lower bound of the distance of the patch from B

  bool operator<(const Patch& p) const { return least > p.least; }  // smallest first
};

struct Search {
  const Meridian& a;
  const Meridian& b;
  Pose X_BA_in_B;  ///< A's frame in B's
  Gap best{std::numeric_limits<double>::infinity(), {}, 0.0};

  const ShellPoint& start(std::size_t side) const { return a[side]; }
  const ShellPoint& end(std::size_t side) const { return a[(side + 1) % a.size()]; }

  /// Measures the middle of a patch and bounds its other points.
  void measure(Patch& p) {
    const ShellPoint &from = start(p.side), &to = end(p.side);
    const ShellPoint at{from.s + p.along * (to.s - from.s), from.r + p.along * (to.r - from.r)};
    const Vec3 x = X_BA_in_B * Vec3(at.r * std::cos(p.angle), at.r * std::sin(p.angle), -at.s);
    const double distance = signed_distance(b, {-x.z(), std::hypot(x.x(), x.y())});
    if (distance < best.distance) best = {distance, at, p.angle};
    const double slide = p.half_along * std::hypot(to.s - from.s, to.r - from.r);
    p.least = distance - slide - (at.r + slide) * p.half_angle;
  }

  /// Bisects the patch in its longer direction.
  std::pair<Patch, Patch> halves(const Patch& p) const {
    const ShellPoint &from = start(p.side), &to = end(p.side);
    const double length = p.half_along * std::hypot(to.s - from.s, to.r - from.r);
    const double arc = p.half_angle * std::max(from.r, to.r);
    Patch lo = p, hi = p;
    double Patch::*const middle = length > arc ? &Patch::along : &Patch::angle;
    double Patch::*const half = length > arc ? &Patch::half_along : &Patch::half_angle;
    lo.*half = hi.*half = 0.5 * (p.*half);
    lo.*middle -= lo.*half;
    hi.*middle += hi.*half;
    return {lo, hi};
  }
};

}  // namespace

Gap smallest_gap(const Meridian& a, const Pose& X_BA, const Meridian& b, const Pose& X_BB,
                 double tolerance, double enough) {
  Search search{a, b, inverse(X_BB) * X_BA};
  std::priority_queue<Patch> patches;
  const auto add = [&](Patch p) {
    search.measure(p);
    patches.push(p);
  };
  for (std::size_t side = 0; side < a.size(); ++side) add({side, 0.5, 0.5, pi, pi, 0.0});
  for (long read_state = 0; !patches.empty(); ++read_state) {
    const Patch p = patches.top();
    patches.pop();
    if (p.least >= search.best.distance - tolerance || p.least >= enough) break;
    if (read_state == most_patches) {
      search.best.is_exact = false;
      break;
    }
    const auto [lo, hi] = search.halves(p);
    add(lo);
    add(hi);
  }
  return search.best;
}

namespace {

double within_turn(double angle) {
  const double turned = std::fmod(angle, full_turn);
  return turned < 0.0 ? turned + full_turn : turned;
}

Clearance described(const Gap& gap, const Cone& a, const Turning& of_a, const Cone& b,
                    const Turning& of_b) {
  const Vec3 place_B = a.X_BK * Vec3(gap.point_a.r * std::cos(gap.angle_a),
                                     gap.point_a.r * std::sin(gap.angle_a), -gap.point_a.s);
  const Vec3 place_K = inverse(b.X_BK) * place_B;
  return {of_a.part,
          of_b.part,
          gap.distance,
          within_turn(gap.angle_a - of_a.first_angle),
          within_turn(std::atan2(place_K.y(), place_K.x()) - of_b.first_angle),
          place_B,
          gap.is_exact};
}

void add_pair(const Cone& a, const Cone& b, std::vector<Clearance>& all) {
  const std::vector<Turning> parts_a = turning_parts(a), parts_b = turning_parts(b);
  std::vector<Clearance> clashes;
  Clearance nearest;
  nearest.distance = INFINITY;
  for (const Turning& of_a : parts_a)
    for (const Turning& of_b : parts_b) {
      const Gap gap = smallest_gap(of_a.meridian, a.X_BK, of_b.meridian, b.X_BK,
                                   clearance_tolerance, std::max(0.0, nearest.distance));
      const Clearance here = described(gap, a, of_a, b, of_b);
      if (is_clash(here)) clashes.push_back(here);
      if (here.distance < nearest.distance) nearest = here;
    }
  if (clashes.empty()) clashes.push_back(nearest);
  all.insert(all.end(), clashes.begin(), clashes.end());
}

}  // namespace

std::vector<Turning> turning_parts(const Cone& cone) {
  std::vector<Turning> parts{{cone.name + "/body", 0.0, shell_meridian(cone.layout.shell)}};
  for (std::size_t j = 0; j < cone.layout.rows.size(); ++j) {
    const ToothRow& row = cone.layout.rows[j];
    parts.push_back({fmt::format("{}/row-{}/tooth-1", cone.name, j + 1), row.angles.front(),
                     row_meridian(cone.layout, row)});
  }
  return parts;
}

std::vector<Clearance> cone_clearances(const std::vector<Cone>& cones) {
  std::vector<Clearance> all;
  for (std::size_t i = 0; i < cones.size(); ++i)
    for (std::size_t k = i + 1; k < cones.size(); ++k)
      if (!cones[i].layout.shell.empty() && !cones[k].layout.shell.empty())
        add_pair(cones[i], cones[k], all);
  std::ranges::stable_sort(all, {}, &Clearance::distance);
  return all;
}

std::string clearance_text(const Clearance& c) {
  if (!c.is_exact && c.distance > -clearance_tolerance)
    return fmt::format(
        "{} and {} about {:.3f} mm apart all over, near ({:.1f}, {:.1f}, {:.1f}) mm and elsewhere "
        "(given up after {} patches; two cones in one place?)",
        c.part_a, c.part_b, 1e3 * std::abs(c.distance), 1e3 * c.place_B.x(), 1e3 * c.place_B.y(),
        1e3 * c.place_B.z(), most_patches);
  return fmt::format(
      "{} of {:.3f} mm of {} (at {:.1f} deg) and {} (at {:.1f} deg) at ({:.1f}, {:.1f}, {:.1f}) mm",
      c.distance < 0.0 ? "an overlap" : "a gap", 1e3 * std::abs(c.distance), c.part_a,
      c.angle_a / degree, c.part_b, c.angle_b / degree, 1e3 * c.place_B.x(), 1e3 * c.place_B.y(),
      1e3 * c.place_B.z());
}

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
  for (long read_state = 0; !patches.empty(); ++read_state) {
    const LegPatch p = patches.top();
    patches.pop();
    if (p.least >= best.distance - clearance_tolerance || p.least >= enough) break;
    if (read_state == most_patches) {
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
