#include "rock/maintain/bisect.hpp"

#include "mesh/edit.hpp"
#include "rock/maintain/check_operation.hpp"

namespace tdbd::rock {

bool bisect_edge(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                 MaintenanceReport& report) {
  mesh::Surface& s = rock.surface;
  const int c = mesh::corner_facing(s, a, b);
  if (c < 0 || s.opposite_of(c) < 0) {
    count_refused(report, Operation::bisection, Refusal::boundary);
    return false;
  }
  if ((s.position(b) - s.position(a)).norm() <= limits.longest_edge) return false;
  const int o = s.opposite_of(c);
  const int p = s.vertex(c), q = s.vertex(o);
  const int last_part = rock.last_part[at(a)];
  LocalState before;
  if constexpr (check_every_operation) before = local_state(s, {a, b, p, q});
  const int m = mesh::split_edge(s, c, 0.5 * (s.position(a) + s.position(b)));
  register_vertex(rock, m, last_part);
  note_carried(rock, {m, {a, b, a}, {0.5, 0.5, 0.0}});
  ring.assign({a, b, p, q, m});
  for (const int v : ring) touch(rock, v);
  count_done(report, Operation::bisection, 0.0);
  if constexpr (check_every_operation) require_promises_around(rock, before, 0.0, "bisections");
  return true;
}

}  // namespace tdbd::rock
