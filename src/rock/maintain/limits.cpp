#include "rock/maintain/limits.hpp"

#include <cmath>
#include <numeric>

#include "rock/maintain/invariants.hpp"

namespace tdbd::rock {

void set_shortest_edge(MaintenanceLimits& l, double shortest) {
  constexpr double below = 1.0 - 1e-9;  // M6 requires "less than"; guards and check round
  l.shortest_edge = shortest;
  l.farthest = below * 0.5 * shortest;
  l.untangle_farthest = below * 2.0 * shortest;
}

MaintenanceLimits limits_for(double edge_length, const MaintenanceOptions& options) {
  MaintenanceLimits l;
  set_shortest_edge(l, options.shortest_edge * edge_length);
  l.longest_edge = options.longest_edge * edge_length;
  l.rest = static_cast<int>(options.rest);
  l.longest_wait = static_cast<int>(options.longest_wait);
  l.worst_quality = options.worst_quality;
  l.flip_quality = options.flip_quality;
  l.smoothing = options.smoothing;
  l.smooth_quality = options.smooth_quality;
  l.volume_per_operation = 0.01 * edge_length * edge_length * edge_length;
  l.ridge_cut = 0.05 * edge_length;
  l.untangle_volume = 20.0 * l.volume_per_operation;
  return l;
}

void count_done(MaintenanceReport& report, Operation what, double volume) {
  ++report.done[static_cast<std::size_t>(what)];
  report.volume_change += volume;
  report.volume_disturbed += std::abs(volume);
}

void count_refused(MaintenanceReport& report, Operation what, Refusal why) {
  ++report.refused[static_cast<std::size_t>(what)][static_cast<std::size_t>(why)];
}

long refusals(const MaintenanceReport& report) {
  long sum = 0;
  for (const auto& by_reason : report.refused)
    sum = std::accumulate(by_reason.begin(), by_reason.end(), sum);
  return sum;
}

void add(const MaintenanceReport& more, MaintenanceReport& sum) {
  for (std::size_t o = 0; o < sum.done.size(); ++o) {
    sum.done[o] += more.done[o];
    for (std::size_t r = 0; r < sum.refused[o].size(); ++r) sum.refused[o][r] += more.refused[o][r];
  }
  sum.touched_triangles += more.touched_triangles;
  sum.volume_change += more.volume_change;
  sum.volume_disturbed += more.volume_disturbed;
}

std::vector<std::pair<std::string, long>> counts(const MaintenanceReport& report) {
  std::vector<std::pair<std::string, long>> all;
  all.reserve(report.done.size() * (1 + refusal_names.size()));
  for (std::size_t o = 0; o < report.done.size(); ++o)
    all.emplace_back(operation_names[o], report.done[o]);
  for (std::size_t o = 0; o < report.done.size(); ++o)
    for (std::size_t r = 0; r < refusal_names.size(); ++r)
      all.emplace_back(std::string("refused_") + operation_names[o] + "_" + refusal_names[r],
                       report.refused[o][r]);
  return all;
}

namespace {

/// Whether a triangle at a corner of t is turned by more than 90 degrees against t.
bool is_turned_against_neighbour(const mesh::Surface& s, int t, const Vec3& area) {
  bool found = false;
  for (const int v : s.triangles[at(t)])
    if (!found)
      mesh::visit_corners(
          s, v, [&](int c) { found = found || area.dot(doubled_area(facet_at(s, c))) < 0.0; });
  return found;
}

}  // namespace

double worst_quality(const mesh::Surface& s, int v) {
  double worst = 1.0;
  mesh::visit_corners(s, v, [&](int c) { worst = std::min(worst, quality(facet_at(s, c))); });
  return worst;
}

std::optional<Refusal> judge_turn(const Vec3& before, const Vec3& after,
                                  const MaintenanceLimits& limits) {
  if (after.dot(before) < limits.least_normal_cosine * after.norm() * before.norm())
    return Refusal::normal;
  const double lean = limits.steepest_overhang * after.norm();  // z is down
  if (after.z() > lean && before.z() <= limits.steepest_overhang * before.norm())
    return Refusal::overhang;
  if (after.z() >= 0.0 && before.z() < -limits.steepest_overhang * before.norm())
    return Refusal::overhang;
  return std::nullopt;
}

bool is_sharp(const mesh::Surface& s, int c, const MaintenanceLimits& limits) {
  const int o = s.opposite_of(c);
  if (o < 0) return false;
  const Vec3 m = area_vector(facet_at(s, c)), n = area_vector(facet_at(s, o));
  return m.dot(n) < limits.sharp_cosine * m.norm() * n.norm();
}

bool is_on_ridge(const mesh::Surface& s, int v, const MaintenanceLimits& limits) {
  bool found = false;
  mesh::visit_corners(s, v,
                      [&](int c) { found = found || is_sharp(s, mesh::next_corner(c), limits); });
  return found;
}

bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t) {
  const Vec3 area = doubled_area(facet_at(s, 3 * t));
  return area.z() > -limits.steepest_overhang * area.norm() &&
         is_turned_against_neighbour(s, t, area);
}

void SurfaceDrift::note(int v, double distance) {
  if (distance <= 0.0) return;
  if (at(v) >= by_vertex_.size()) by_vertex_.resize(at(v) + 1 + at(v) / 8, 0.0);
  if (by_vertex_[at(v)] == 0.0) listed_.push_back(v);
  by_vertex_[at(v)] = std::max(by_vertex_[at(v)], distance);
}

void SurfaceDrift::clear() {
  for (const int v : listed_) by_vertex_[at(v)] = 0.0;
  listed_.clear();
}

double largest_drift_around(const mesh::Surface& s, int v, const SurfaceDrift& drift) {
  double largest = drift.of(v);
  mesh::visit_corners(
      s, v, [&](int c) { largest = std::max(largest, drift.of(s.vertex(mesh::next_corner(c)))); });
  return largest;
}

namespace {

/// The displacement that vertex v carries to the point x_W of its star: linearly interpolated on
/// the triangle that contains x_W or is nearest to it.
InterpolatedDisplacement interpolated_at(const mesh::Surface& s, int v, const Vec3& x_W) {
  InterpolatedDisplacement best{v, {v, v, v}, {1.0, 0.0, 0.0}};
  double least = -std::numeric_limits<double>::infinity();
  mesh::visit_corners(s, v, [&](int c) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    const Vec3 e1 = s.position(a) - s.position(v), e2 = s.position(b) - s.position(v);
    const Vec3 n = e1.cross(e2), r = x_W - s.position(v);
    const double n2 = n.squaredNorm();
    if (n2 == 0.0) return;
    const double to_a = r.cross(e2).dot(n) / n2, to_b = e1.cross(r).dot(n) / n2;
    const double inside = std::min({to_a, to_b, 1.0 - to_a - to_b});
    if (inside <= least) return;
    least = inside;
    const double at_a = std::max(to_a, 0.0), at_b = std::max(to_b, 0.0);
    const double sum = std::max(at_a + at_b, 1.0);
    best = {v, {v, a, b}, {1.0 - (at_a + at_b) / sum, at_a / sum, at_b / sum}};
  });
  return best;
}

}  // namespace

bool move_if_accepted(Rock& rock, int v, const Vec3& x_W, Operation what, const Verdict& verdict,
                      SurfaceDrift& drift, MaintenanceReport& report) {
  if (verdict.refused) {
    count_refused(report, what, *verdict.refused);
    return false;
  }
  LocalState before;
  if constexpr (check_every_operation) before = local_state(rock.surface, {v});
  if (has_displacements(rock)) record_carried(rock, interpolated_at(rock.surface, v, x_W));
  place_vertex(rock, v, x_W);
  mark_neighbours_changed(rock, v);
  drift.note(v, verdict.drift);
  count_done(report, what, verdict.volume);
  if constexpr (check_every_operation)
    require_promises_around(rock, before, verdict.volume, name_of(what));
  return true;
}

}  // namespace tdbd::rock
