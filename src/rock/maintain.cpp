#include "rock/maintain.hpp"

#include <algorithm>
#include <tuple>

#include "mesh/measures.hpp"
#include "rock/bisect.hpp"
#include "rock/collapse.hpp"

namespace tdbd::rock {
namespace {

using Candidate = MaintenanceWorkspace::Candidate;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double edge_length(const mesh::Surface& s, int a, int b) {
  return (s.position(b) - s.position(a)).norm();
}

/// Every edge at a touched vertex once, as (a, b) with a < b when both ends are touched.
template <class Visit>
void visit_touched_edges(const Rock& rock, const std::vector<int>& touched, Visit&& visit) {
  const mesh::Surface& s = rock.surface;
  for (const int v : touched) {
    if (!s.is_alive(v)) continue;
    mesh::visit_corners(s, v, [&](int c) {
      const int w = s.vertex(mesh::next_corner(c));
      if (v < w || !rock.touched[at(w)]) visit(std::min(v, w), std::max(v, w), c);
      const int x = s.vertex(mesh::previous_corner(c));  // the fan's open end at a boundary
      if (mesh::turn_left(s, c) < 0 && (v < x || !rock.touched[at(x)]))
        visit(std::min(v, x), std::max(v, x), c);
    });
  }
}

bool shorter(const Candidate& x, const Candidate& y) {
  return std::tie(x.key, x.a, x.b) < std::tie(y.key, y.a, y.b);
}
bool longer(const Candidate& x, const Candidate& y) {
  return std::tie(y.key, x.a, x.b) < std::tie(x.key, y.a, y.b);
}

/// Rounds of bisection: a round's new edges are looked at in the next. Each halves the longest.
void bisect_long_edges(Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work,
                       MaintenanceReport& report) {
  constexpr int most_rounds = 24;
  for (int round = 0; round < most_rounds; ++round) {
    work.edges.clear();
    visit_touched_edges(rock, rock.touched_list, [&](int a, int b, int) {
      const double length = edge_length(rock.surface, a, b);
      if (length > limits.longest_edge) work.edges.push_back({length, a, b});
    });
    std::sort(work.edges.begin(), work.edges.end(), longer);
    const long before = report.bisections;
    for (const Candidate& e : work.edges) bisect_edge(rock, e.a, e.b, limits, report);
    if (report.bisections == before) return;
  }
}

/// If triangle t is badly shaped, its shortest edge (4.2.4.4).
void find_bad_shape(const mesh::Surface& s, int t, const MaintenanceLimits& limits,
                    std::vector<Candidate>& edges) {
  const mesh::Triangle& v = s.triangles[at(t)];
  if (mesh::triangle_quality(s.position(v[0]), s.position(v[1]), s.position(v[2])) >=
      limits.worst_quality)
    return;
  Candidate shortest{1e300, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const int p = std::min(v[i], v[(i + 1) % 3]), q = std::max(v[i], v[(i + 1) % 3]);
    const Candidate e{edge_length(s, p, q), p, q};
    if (shorter(e, shortest)) shortest = e;
  }
  edges.push_back(shortest);
}

/// Short edges, and the shortest edge of every badly shaped triangle (4.2.1), each once, shortest
/// first: at all touched vertices, or in a later round where the one before changed something.
void find_collapses(const Rock& rock, const MaintenanceLimits& limits, bool first_round,
                    MaintenanceWorkspace& work) {
  const mesh::Surface& s = rock.surface;
  work.edges.clear();
  const auto look = [&](int a, int b, int c) {
    const double length = edge_length(s, a, b);
    if (length < limits.shortest_edge) work.edges.push_back({length, a, b});
    find_bad_shape(s, c / 3, limits, work.edges);
  };
  if (first_round) visit_touched_edges(rock, rock.touched_list, look);
  for (const int v : work.changed)
    if (s.is_alive(v))
      mesh::visit_corners(s, v, [&](int c) {
        for (const int w : {s.vertex(mesh::next_corner(c)), s.vertex(mesh::previous_corner(c))})
          look(std::min(v, w), std::max(v, w), c);
      });
  std::sort(work.edges.begin(), work.edges.end(), shorter);
  const auto same = [](const Candidate& x, const Candidate& y) { return x.a == y.a && x.b == y.b; };
  work.edges.erase(std::unique(work.edges.begin(), work.edges.end(), same), work.edges.end());
}

/// Rounds of collapses until one carries out none: a collapse may shorten an edge beside it, or
/// remove what another was refused for. What was refused is asked again only where the surface
/// changed; each round but the last has fewer vertices, so rounds end.
void collapse_short_edges(Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work,
                          MaintenanceReport& report) {
  work.changed.clear();
  for (bool first_round = true; first_round || !work.changed.empty(); first_round = false) {
    find_collapses(rock, limits, first_round, work);
    work.changed.clear();
    for (const Candidate& e : work.edges) {
      if (!rock.surface.is_alive(e.a) || !rock.surface.is_alive(e.b)) continue;
      const long before = report.collapses;
      try_collapse(rock, e.a, e.b, limits, work.ring, report);
      if (report.collapses > before)
        work.changed.insert(work.changed.end(), work.ring.begin(), work.ring.end());
    }
    std::sort(work.changed.begin(), work.changed.end());
    work.changed.erase(std::unique(work.changed.begin(), work.changed.end()), work.changed.end());
  }
}

}  // namespace

MaintenanceLimits limits_for(double edge_length) {
  MaintenanceLimits l;
  l.shortest_edge = 0.4 * edge_length;
  l.longest_edge = 1.6 * edge_length;
  l.volume_per_collapse = 0.01 * edge_length * edge_length * edge_length;
  return l;
}

void maintain(Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work,
              MaintenanceReport& report) {
  bisect_long_edges(rock, limits, work, report);
  collapse_short_edges(rock, limits, work, report);
  rock.grid.refresh_one_layer();
  for (const int v : rock.touched_list) rock.touched[at(v)] = 0;
  rock.touched_list.clear();
}

}  // namespace tdbd::rock
