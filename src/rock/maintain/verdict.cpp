#include "rock/maintain/verdict.hpp"

#include "rock/maintain/check_operation.hpp"

namespace tdbd::rock {

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

bool move_if_accepted(Rock& rock, int v, const Vec3& x_W, Operation what, const Verdict& verdict,
                      SurfaceDrift& drift, MaintenanceReport& report) {
  if (verdict.refused) {
    count_refused(report, what, *verdict.refused);
    return false;
  }
  LocalState before;
  if constexpr (check_every_operation) before = local_state(rock.surface, {v});
  place_vertex(rock, v, x_W);
  touch_neighbours(rock, v);
  drift.note(v, verdict.drift);
  count_done(report, what, verdict.volume);
  if constexpr (check_every_operation)
    require_promises_around(rock, before, verdict.volume, name_of(what));
  return true;
}

}  // namespace tdbd::rock
