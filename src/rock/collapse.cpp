#include "rock/collapse.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/edit.hpp"
#include "mesh/measures.hpp"

namespace tdbd::rock {
namespace {

/// What a collapse to one place would do.
struct Trial {
  Vec3 x_W;
  double volume = 0.0;  ///< m3 of hole gained
};

/// Signed volume under the triangles of both stars about o, with a and b at the given places.
double star_volume(const mesh::Surface& s, int a, int b, const Vec3& xa, const Vec3& xb,
                   const Vec3& o) {
  const auto place = [&](int v) -> Vec3 { return (v == a ? xa : v == b ? xb : s.position(v)) - o; };
  double six = 0.0;
  const auto add = [&](int c, int other) {
    const mesh::Triangle& t = s.triangles[static_cast<std::size_t>(c / 3)];
    if (t[0] == other || t[1] == other || t[2] == other) return;
    six += place(t[0]).dot(place(t[1]).cross(place(t[2])));
  };
  mesh::visit_corners(s, a, [&](int c) { add(c, -1); });
  mesh::visit_corners(s, b, [&](int c) { add(c, a); });
  return six / 6.0;
}

/// Guards on one triangle around v, whose corner there goes to x. Nothing: accepted.
std::optional<Refusal> judge(const mesh::Surface& s, int c, const Vec3& x, double quality_floor,
                             const MaintenanceLimits& limits) {
  const Vec3& p = s.position(s.vertex(mesh::next_corner(c)));
  const Vec3& q = s.position(s.vertex(mesh::previous_corner(c)));
  const Vec3 before = mesh::area_vector(s.position(s.vertex(c)), p, q),
             after = mesh::area_vector(x, p, q);
  if (after.dot(before) < limits.least_normal_cosine * after.norm() * before.norm())
    return Refusal::normal;
  if (before.z() < 0.0 && after.z() >= 0.0) return Refusal::overhang;
  if ((p - x).norm() > limits.longest_edge) return Refusal::too_long;
  if (mesh::triangle_quality(x, p, q) < quality_floor) return Refusal::quality;
  return std::nullopt;
}

double worst_quality(const mesh::Surface& s, int v) {
  double worst = 1.0;
  mesh::visit_corners(s, v, [&](int c) {
    worst = std::min(worst, mesh::triangle_quality(s.position(s.vertex(c)),
                                                   s.position(s.vertex(mesh::next_corner(c))),
                                                   s.position(s.vertex(mesh::previous_corner(c)))));
  });
  return worst;
}

std::optional<Refusal> judge_star(const mesh::Surface& s, int v, int other, const Vec3& x,
                                  double quality_floor, const MaintenanceLimits& limits) {
  std::optional<Refusal> why;
  mesh::visit_corners(s, v, [&](int c) {
    if (why || s.vertex(mesh::next_corner(c)) == other ||
        s.vertex(mesh::previous_corner(c)) == other)
      return;
    why = judge(s, c, x, quality_floor, limits);
  });
  return why;
}

std::array<Trial, 3> trials(const mesh::Surface& s, int a, int b) {
  const Vec3 &xa = s.position(a), &xb = s.position(b);
  const Vec3 o = 0.5 * (xa + xb);
  const double before = star_volume(s, a, b, xa, xb, o);
  std::array<Trial, 3> all{{{o, 0.0}, {xa, 0.0}, {xb, 0.0}}};
  for (Trial& t : all) t.volume = -(star_volume(s, a, b, t.x_W, t.x_W, o) - before);
  std::stable_sort(all.begin(), all.end(), [](const Trial& x, const Trial& y) {
    return std::abs(x.volume) < std::abs(y.volume);
  });
  return all;
}

std::optional<Refusal> judge_trial(const mesh::Surface& s, int a, int b, const Trial& t,
                                   double quality_floor, const MaintenanceLimits& limits) {
  if (std::abs(t.volume) > limits.volume_per_collapse) return Refusal::volume;
  if (const auto why = judge_star(s, a, b, t.x_W, quality_floor, limits)) return why;
  return judge_star(s, b, a, t.x_W, quality_floor, limits);
}

void carry_out(Rock& rock, const CollapseVerdict& verdict, std::vector<int>& ring,
               MaintenanceReport& report) {
  mesh::Surface& s = rock.surface;
  const int c = verdict.corner;
  const int keep = s.vertex(mesh::next_corner(c)), gone = s.vertex(mesh::previous_corner(c));
  ring.clear();
  for (const int v : {keep, gone})
    mesh::visit_corners(s, v, [&](int k) { ring.push_back(s.vertex(mesh::next_corner(k))); });
  mesh::collapse_edge(s, c, verdict.x_W);
  rock.grid.remove(gone);
  rock.grid.move(keep, verdict.x_W);
  for (const int v : ring)
    if (v != gone) touch(rock, v);
  ++report.collapses;
  report.volume_change += verdict.volume;
  report.volume_disturbed += std::abs(verdict.volume);
}

}  // namespace

CollapseVerdict judge_collapse(const mesh::Surface& s, int a, int b,
                               const MaintenanceLimits& limits) {
  CollapseVerdict v;
  if (s.is_boundary(a) || s.is_boundary(b)) {
    v.refused = Refusal::boundary;
    return v;
  }
  v.corner = mesh::corner_facing(s, a, b);
  if (v.corner < 0) return v;
  if (!mesh::collapse_keeps_topology(s, v.corner)) {
    v.refused = Refusal::topology;
    return v;
  }
  const double floor = std::min(0.3, std::min(worst_quality(s, a), worst_quality(s, b)));
  for (const Trial& t : trials(s, a, b)) {
    const auto why = judge_trial(s, a, b, t, floor, limits);
    if (!why) {
      v.refused.reset();
      v.x_W = t.x_W;
      v.volume = t.volume;
      return v;
    }
    if (!v.refused) v.refused = why;
  }
  return v;
}

void try_collapse(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                  MaintenanceReport& report) {
  const CollapseVerdict v = judge_collapse(rock.surface, a, b, limits);
  if (v.refused)
    ++report.refused[static_cast<std::size_t>(*v.refused)];
  else if (v.corner >= 0)  // otherwise an earlier collapse took the edge
    carry_out(rock, v, ring, report);
}

}  // namespace tdbd::rock
