#include "rock/maintain/maintain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "core/error.hpp"
#include "core/sort_unique.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/operations.hpp"
#include "rock/maintain/untangle.hpp"

namespace tdbd::rock {

EdgeCandidate edge_facing(const mesh::Surface& s, int c, double key) {
  const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
  return {key, std::min(a, b), std::max(a, b)};
}

void sort_edges(std::vector<EdgeCandidate>& edges) {
  sort_unique(
      edges,
      [](const EdgeCandidate& x, const EdgeCandidate& y) {
        return std::tie(x.key, x.a, x.b) < std::tie(y.key, y.a, y.b);
      },
      [](const EdgeCandidate& x, const EdgeCandidate& y) { return x.a == y.a && x.b == y.b; });
}

namespace {

using Work = MaintenanceWorkspace;

/// Counts a round after which `left` remains to be done. Throws RunError if there were too many.
void count_round(const Rock& rock, const std::vector<int>& left, const MaintenanceLimits& limits,
                 int& rounds) {
  if (left.empty() || ++rounds < limits.most_rounds) return;
  const Vec3 x_W = 1e3 * rock.surface.position(left.front());
  throw RunError(fmt::format(
      "maintenance of the rock does not end: after {} rounds there is more to do at ({:.3f}, "
      "{:.3f}, {:.3f}) mm",
      rounds, x_W.x(), x_W.y(), x_W.z()));
}

/// Visits every triangle at the given vertices once, with its shape.
template <class Visit>
void visit_triangles(const mesh::Surface& s, const std::vector<int>& vertices, Work& work,
                     Visit&& visit) {
  ++work.stamp;
  work.seen.resize(s.triangles.size(), 0);
  for (const int v : vertices)
    if (s.is_alive(v))
      mesh::visit_corners(s, v, [&](int c) {
        const int t = c / 3;
        if (work.seen[at(t)] == work.stamp) return;
        work.seen[at(t)] = work.stamp;
        visit(t, shape_of(s, t));
      });
}

/// Visits the touched triangles that were classified for an operation and all triangles that
/// changed since, with their shapes. A triangle may be visited twice.
template <class Visit>
void visit_touched(const Rock& rock, const std::vector<int>& wanted, Work& work, Visit&& visit) {
  for (const int t : wanted)
    if (rock.surface.triangle_is_alive(t)) visit(t, shape_of(rock.surface, t));
  find_changed(rock, work.touched);
  visit_triangles(rock.surface, work.touched.changed, work, visit);
}

/// Where an operation searches: in the touched region the first time, then at the vertices of
/// Work::region.
enum class Where { touched, region };

template <class Visit>
void visit_triangles(const Rock& rock, Where where, const std::vector<int>& wanted, Work& work,
                     Visit&& visit) {
  if (where == Where::touched)
    visit_touched(rock, wanted, work, visit);
  else
    visit_triangles(rock.surface, work.region, work, visit);
}

/// Lowers the tips of spikes among the vertices of touched triangles. A tip below another one is
/// left to the next maintenance.
void blunt_spikes(Rock& rock, const MaintenanceLimits& limits, Work& work,
                  MaintenanceReport& report) {
  const mesh::Surface& s = rock.surface;
  work.changed.clear();
  report.touched_triangles += work.touched.asked;
  for (const int t : work.touched.steep) {
    const mesh::Triangle& v = s.triangles[at(t)];
    const auto higher = [&](int a, int b) { return s.position(a).z() < s.position(b).z(); };
    work.changed.push_back(*std::min_element(v.begin(), v.end(), higher));
  }
  sort_unique(work.changed);
  for (const int v : work.changed) try_blunt(rock, v, limits, work.drift, report);
}

/// Rounds of bisection: each halves the longest edges; the next one examines the new edges.
void bisect_long_edges(Rock& rock, const MaintenanceLimits& limits, Work& work,
                       MaintenanceReport& report) {
  const double longest2 = limits.longest_edge * limits.longest_edge;
  Where where = Where::touched;
  for (int rounds = 0; where == Where::touched || !work.region.empty();
       count_round(rock, work.region, limits, rounds)) {
    work.edges.clear();
    visit_triangles(rock, where, work.touched.with_long_edges, work,
                    [&](int t, const Shape& shape) {
                      for (int i = 0; i < 3; ++i)
                        if (const double l2 = shape.edge2[at(i)]; l2 > longest2) {
                          const EdgeCandidate e = edge_facing(rock.surface, 3 * t + i, -l2);
                          if (rock.touched[at(e.a)] || rock.touched[at(e.b)])
                            work.edges.push_back(e);
                        }
                    });
    sort_edges(work.edges);
    work.region.clear();
    for (const EdgeCandidate& e : work.edges)
      if (bisect_edge(rock, e.a, e.b, limits, work.ring, report))
        work.region.insert(work.region.end(), work.ring.begin(), work.ring.end());
    if (work.region.empty()) return;
    sort_unique(work.region);
    where = Where::region;
  }
}

/// Calls visit(neighbour) for every neighbour that lies back to back with this triangle. Rock that
/// is moved along an upright wall can pass its neighbours there.
template <class Visit>
void visit_folds(const mesh::Surface& s, int t, const Shape& shape, Visit&& visit) {
  for (int c = 3 * t; c < 3 * t + 3; ++c)
    if (const int o = s.opposite_of(c);
        o >= 0 && are_folded(shape.doubled_area, doubled_area(facet_at(s, o))))
      visit(o / 3);
}

bool is_touched(const Rock& rock, int t) {
  return std::ranges::any_of(rock.surface.triangles[at(t)],
                             [&](int v) { return rock.touched[at(v)] != 0; });
}

void add_edges(const mesh::Surface& s, int t, const Shape& shape,
               std::vector<EdgeCandidate>& edges) {
  for (int i = 0; i < 3; ++i) edges.push_back(edge_facing(s, 3 * t + i, shape.edge2[at(i)]));
}

/// Finds short edges, the shortest edge of every badly shaped triangle, and the edges of folds
/// (4.2.1, 4.2.4.4). A change may have folded an unchanged touched triangle.
void find_collapses(const Rock& rock, const MaintenanceLimits& limits, Where where, Work& work) {
  const mesh::Surface& s = rock.surface;
  const double shortest2 = limits.shortest_edge * limits.shortest_edge;
  work.edges.clear();
  visit_triangles(rock, where, work.touched.to_collapse, work, [&](int t, const Shape& shape) {
    bool is_fold = false;
    if (limits.worst_quality > 0.0)
      visit_folds(s, t, shape, [&](int other) {
        is_fold = true;
        if (where == Where::touched && is_touched(rock, other))
          add_edges(s, other, shape_of(s, other), work.edges);
      });
    if (is_fold) return add_edges(s, t, shape, work.edges);
    const bool is_bad = is_below(shape, limits.worst_quality);
    const double least2 = std::ranges::min(shape.edge2);
    if (least2 >= shortest2 && !is_bad) return;
    for (int i = 0; i < 3; ++i)
      if (const double l2 = shape.edge2[at(i)]; l2 < shortest2 || (is_bad && l2 == least2))
        work.edges.push_back(edge_facing(s, 3 * t + i, l2));
  });
  sort_edges(work.edges);
}

void collapse_short_edges(Rock& rock, const MaintenanceLimits& limits, Where where, Work& work,
                          MaintenanceReport& report) {
  find_collapses(rock, limits, where, work);
  for (const EdgeCandidate& e : work.edges) {
    if (!rock.surface.is_alive(e.a) || !rock.surface.is_alive(e.b)) continue;
    if (try_collapse(rock, e.a, e.b, limits, work.ring, work.drift, report))
      work.changed.insert(work.changed.end(), work.ring.begin(), work.ring.end());
  }
}

/// Flips the longest edge of triangles that a flip may improve, worst first.
void flip_edges(Rock& rock, const MaintenanceLimits& limits, Where where, Work& work,
                MaintenanceReport& report) {
  if (limits.flip_quality <= 0.0) return;
  const mesh::Surface& s = rock.surface;
  work.region.insert(work.region.end(), work.changed.begin(), work.changed.end());
  work.edges.clear();
  visit_triangles(rock, where, work.touched.to_flip, work, [&](int t, const Shape& shape) {
    if (!is_below(shape, limits.flip_quality)) return;
    const auto longest = std::max_element(shape.edge2.begin(), shape.edge2.end());
    const int c = 3 * t + static_cast<int>(longest - shape.edge2.begin());
    work.edges.push_back(edge_facing(s, c, shape.quality2));
  });
  sort_edges(work.edges);
  for (const EdgeCandidate& e : work.edges) {
    const int c = mesh::corner_facing(s, e.a, e.b);
    if (c < 0) continue;
    const int p = s.vertex(c);
    if (try_flip(rock, c, limits, work.drift, report))
      work.changed.insert(work.changed.end(), {e.a, e.b, p, s.vertex(mesh::previous_corner(c))});
  }
}

/// Repeats collapses and flips until a round carries out none. An operation may make another one
/// beside it necessary, or remove the reason of a refusal. Refused operations are tried again only
/// where the surface changed. The rounds end because collapses reduce the number of vertices and
/// flips improve triangles.
void repair(Rock& rock, const MaintenanceLimits& limits, Where where, Work& work,
            MaintenanceReport& report) {
  for (int rounds = 0; where == Where::touched || !work.region.empty();
       count_round(rock, work.region, limits, rounds)) {
    work.changed.clear();
    collapse_short_edges(rock, limits, where, work, report);
    flip_edges(rock, limits, where, work, report);
    sort_unique(work.changed);
    std::swap(work.region, work.changed);
    where = Where::region;
  }
}

/// Smooths every vertex of the touched triangles that need it, once. `work.region` receives the
/// vertices whose triangles changed.
void smooth_vertices(Rock& rock, const MaintenanceLimits& limits, Work& work,
                     MaintenanceReport& report) {
  work.region.clear();
  if (limits.smoothing == Smoothing::off) return;
  const mesh::Surface& s = rock.surface;
  work.changed.clear();
  visit_touched(rock, work.touched.to_smooth, work, [&](int t, const Shape& shape) {
    if (!is_below(shape, limits.smooth_quality)) return;
    for (int c = 3 * t; c < 3 * t + 3; ++c) work.changed.push_back(s.vertex(c));
  });
  sort_unique(work.changed);
  for (const int v : work.changed) {
    if (!try_smooth(rock, v, limits, work.drift, report)) continue;
    work.region.push_back(v);
    mesh::visit_corners(s, v,
                        [&](int c) { work.region.push_back(s.vertex(mesh::next_corner(c))); });
  }
  sort_unique(work.region);
}

}  // namespace

void maintain(Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work,
              MaintenanceReport& report) {
  work.drift.clear();
  begin_notes(rock, limits, work.old_notes, work.unknown);
  defer_vertices(rock, limits, work.waiting);
  classify_touched_triangles(rock, limits, work.touched);
  const std::vector<int> folded = find_folded_places(rock, limits, work);
  blunt_spikes(rock, limits, work, report);
  bisect_long_edges(rock, limits, work, report);
  repair(rock, limits, Where::touched, work, report);
  smooth_vertices(rock, limits, work, report);
  repair(rock, limits, Where::region, work, report);
  constexpr int most_untanglings = 5;  // the rest waits until it is touched again
  for (int k = 0; k < most_untanglings && untangle(rock, folded, limits, work, report); ++k)
    repair(rock, limits, Where::region, work, report);
  deepen_index(rock);
  rock.grid.refresh_one_layer();
  relist_deferred(rock, limits, work.waiting);
}

}  // namespace tdbd::rock
