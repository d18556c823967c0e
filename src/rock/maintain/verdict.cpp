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

namespace {

/// The displacement that vertex v carries to the point x_W of its star: linearly interpolated on
/// the triangle that contains x_W or is nearest to it.
CarriedDisplacement carried_to(const mesh::Surface& s, int v, const Vec3& x_W) {
  CarriedDisplacement best{v, {v, v, v}, {1.0, 0.0, 0.0}};
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
  if (has_displacements(rock)) note_carried(rock, carried_to(rock.surface, v, x_W));
  place_vertex(rock, v, x_W);
  touch_neighbours(rock, v);
  drift.note(v, verdict.drift);
  count_done(report, what, verdict.volume);
  if constexpr (check_every_operation)
    require_promises_around(rock, before, verdict.volume, name_of(what));
  return true;
}

}  // namespace tdbd::rock
