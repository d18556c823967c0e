#include "rock/bisect.hpp"

#include "mesh/edit.hpp"

namespace tdbd::rock {

void bisect_edge(Rock& rock, int a, int b, const MaintenanceLimits& limits,
                 MaintenanceReport& report) {
  mesh::Surface& s = rock.surface;
  const int c = mesh::corner_facing(s, a, b);
  if (c < 0 || s.opposite_of(c) < 0) {
    ++report.refused[static_cast<std::size_t>(Refusal::boundary)];
    return;
  }
  if ((s.position(b) - s.position(a)).norm() <= limits.longest_edge) return;
  const int o = s.opposite_of(c);
  const int p = s.vertex(c), q = s.vertex(o);
  const int last_part = rock.last_part[static_cast<std::size_t>(a)];
  const int m = mesh::split_edge(s, c, 0.5 * (s.position(a) + s.position(b)));
  register_vertex(rock, m, last_part);
  for (const int v : {a, b, p, q, m}) touch(rock, v);
  ++report.bisections;
}

}  // namespace tdbd::rock
