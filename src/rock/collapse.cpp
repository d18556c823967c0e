#include "rock/collapse.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/edit.hpp"
#include "mesh/measures.hpp"

namespace tdbd::rock {
namespace {

/// What a collapse to one place would do.
struct Trial {
  Vec3 x_W;
  double volume = 0.0;  ///< m3 of hole gained
};

void count(MaintenanceReport& report, Refusal why) {
  ++report.refused[static_cast<std::size_t>(why)];
}

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

void carry_out(Rock& rock, int c, const Trial& trial, std::vector<int>& ring,
               MaintenanceReport& report) {
  mesh::Surface& s = rock.surface;
  const int keep = s.vertex(mesh::next_corner(c)), gone = s.vertex(mesh::previous_corner(c));
  ring.clear();
  for (const int v : {keep, gone})
    mesh::visit_corners(s, v, [&](int k) { ring.push_back(s.vertex(mesh::next_corner(k))); });
  mesh::collapse_edge(s, c, trial.x_W);
  rock.grid.remove(gone);
  rock.grid.move(keep, trial.x_W);
  for (const int v : ring)
    if (v != gone) touch(rock, v);
  ++report.collapses;
  report.volume_change += trial.volume;
  report.volume_disturbed += std::abs(trial.volume);
}

}  // namespace

void try_collapse(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                  MaintenanceReport& report) {
  const mesh::Surface& s = rock.surface;
  if (s.is_boundary(a) || s.is_boundary(b)) return count(report, Refusal::boundary);
  const int c = mesh::corner_facing(s, a, b);
  if (c < 0) return;  // an earlier collapse took the edge
  if (!mesh::collapse_keeps_topology(s, c)) return count(report, Refusal::topology);
  const double floor = std::min(0.3, std::min(worst_quality(s, a), worst_quality(s, b)));
  Refusal first = Refusal::volume;
  bool judged = false;
  for (const Trial& t : trials(s, a, b)) {
    std::optional<Refusal> why;
    if (std::abs(t.volume) > limits.volume_per_collapse) why = Refusal::volume;
    if (!why) why = judge_star(s, a, b, t.x_W, floor, limits);
    if (!why) why = judge_star(s, b, a, t.x_W, floor, limits);
    if (!why) return carry_out(rock, c, t, ring, report);
    if (!judged) first = *why;
    judged = true;
  }
  count(report, first);
}

}  // namespace tdbd::rock
