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

/// Short edges, and the shortest edge of every badly shaped triangle (4.2.1, 4.2.4.4).
void find_collapses(const Rock& rock, const MaintenanceLimits& limits, MaintenanceWorkspace& work) {
  const mesh::Surface& s = rock.surface;
  work.edges.clear();
  visit_touched_edges(rock, rock.touched_list, [&](int a, int b, int c) {
    const double length = edge_length(s, a, b);
    if (length < limits.shortest_edge) work.edges.push_back({length, a, b});
    const mesh::Triangle& t = s.triangles[at(c / 3)];
    if (mesh::triangle_quality(s.position(t[0]), s.position(t[1]), s.position(t[2])) >=
        limits.worst_quality)
      return;
    Candidate shortest{1e300, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const int p = std::min(t[i], t[(i + 1) % 3]), q = std::max(t[i], t[(i + 1) % 3]);
      const Candidate e{edge_length(s, p, q), p, q};
      if (shorter(e, shortest)) shortest = e;
    }
    work.edges.push_back(shortest);
  });
  std::sort(work.edges.begin(), work.edges.end(), shorter);
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
  find_collapses(rock, limits, work);
  int last_a = -1, last_b = -1;
  for (const Candidate& e : work.edges) {
    if (e.a == last_a && e.b == last_b) continue;
    last_a = e.a;
    last_b = e.b;
    if (rock.surface.is_alive(e.a) && rock.surface.is_alive(e.b))
      try_collapse(rock, e.a, e.b, limits, work.ring, report);
  }
  rock.grid.refresh_one_layer();
  for (const int v : rock.touched_list) rock.touched[at(v)] = 0;
  rock.touched_list.clear();
}

}  // namespace tdbd::rock
