#include "rock/index/near_region.hpp"

#include <algorithm>
#include <cmath>

#include "rotation/screw.hpp"

namespace tdbd::rock {
namespace {

/// Half the extent along n of a box with these axes.
double spread(const Vec3& n, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& half) {
  return std::abs(n.dot(a)) * half.x() + std::abs(n.dot(b)) * half.y() +
         std::abs(n.dot(c)) * half.z();
}

/// Half the extent along n of the box between orthogonal slabs.
double spread(const Vec3& n, const std::array<Slab, 3>& slabs, const Vec3& half) {
  return spread(n, slabs[0].n, slabs[1].n, slabs[2].n, half);
}

void add(Slab& s, double middle, double half) {
  s.lo = std::min(s.lo, middle - half);
  s.hi = std::max(s.hi, middle + half);
}

void add_box(const mesh::Box& box_P, const Pose& X_WP, std::array<Slab, 3>& slabs) {
  const Vec3 centre_W = X_WP * Vec3(0.5 * (box_P.lo + box_P.hi)), half = 0.5 * box_P.size();
  for (Slab& s : slabs)
    add(s, s.n.dot(centre_W), spread(s.n, X_WP.R.col(0), X_WP.R.col(1), X_WP.R.col(2), half));
}

void add_region(const Region& region_W, std::array<Slab, 3>& slabs) {
  const SlabBox m = slab_box(region_W.slabs);
  for (Slab& s : slabs) add(s, s.n.dot(m.centre_W), spread(s.n, region_W.slabs, m.half));
}

}  // namespace

double way_of(const GroupStep& step) {
  const Vec3 middle_P = 0.5 * (step.box_P.lo + step.box_P.hi);
  return (step.X_WP1 * middle_P - step.X_WP0 * middle_P).norm();
}

bool holds(const Region& region_W, const Region& part_W) {
  const SlabBox m = slab_box(part_W.slabs);
  return std::ranges::all_of(region_W.slabs, [&](const Slab& s) {
    const double at = s.n.dot(m.centre_W), half = spread(s.n, part_W.slabs, m.half);
    return at - half >= s.lo && at + half <= s.hi;
  });
}

Region region_ahead(const GroupStep& step, const NearListMargins& margins, int steps) {
  constexpr double largest_turn = 0.75, sideways = 1e-2;  // rad; times the size of the box
  const rotation::Twist twist = rotation::twist_from(step.X_WP0, step.X_WP1, 1.0);
  const double speed = rotation::velocity_B(twist, 0.5 * (step.box_P.lo + step.box_P.hi)).norm(),
               turn = twist.angular_B.norm();
  double end = steps;
  if (speed > 0.0) end += margins.ahead / speed;
  if (turn > 0.0) end = std::min(end, largest_turn / turn);
  const Pose middle = step.X_WP0 * rotation::carried(twist, 0.5 * end);
  Region r;
  for (std::size_t k = 0; k < r.slabs.size(); ++k)
    r.slabs[k] = {middle.R.col(static_cast<int>(k)), INFINITY, -INFINITY};
  for (const Pose& X_WP : {step.X_WP0, middle, Pose(step.X_WP0 * rotation::carried(twist, end))})
    add_box(step.box_P, X_WP, r.slabs);
  add_region(step.region_W, r.slabs);
  const double half_turn =
      0.5 * end * turn;  // between the region at the end and the axes of the slabs
  const double margin = margins.margin * (std::cos(half_turn) + std::sin(half_turn)) +
                        sideways * step.box_P.size().norm();
  for (Slab& s : r.slabs) {
    s.lo -= margin;
    s.hi += margin;
  }
  r.box = box_around(r.slabs);
  return r;
}

}  // namespace tdbd::rock
