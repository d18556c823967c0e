#include "rock/maintain/touched_region.hpp"

#include <algorithm>

#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/untangle.hpp"

namespace tdbd::rock {
namespace {

void clear(TouchedRegion& r) {
  for (auto* list : {&r.steep, &r.with_long_edges, &r.to_collapse, &r.to_flip, &r.to_smooth,
                     &r.changed, &r.triangles})
    list->clear();
  r.areas.clear();
  r.wants_collapse.clear();
  r.asked = 0;
}

void classify(const mesh::Surface& s, const MaintenanceLimits& limits, int t, TouchedRegion& r) {
  const Shape shape = shape_of(s, t);
  const auto [least2, greatest2] = std::ranges::minmax(shape.edge2);
  const double short2 = limits.shortest_edge * limits.shortest_edge;
  r.place[at(t)] = static_cast<int>(r.triangles.size());
  r.triangles.push_back(t);
  r.areas.push_back(shape.doubled_area);
  r.wants_collapse.push_back(least2 < short2 || is_below(shape, limits.worst_quality) ? 1 : 0);
  if (-0.5 * shape.doubled_area.z() < 0.5 * short2) r.steep.push_back(t);
  if (greatest2 > limits.longest_edge * limits.longest_edge) r.with_long_edges.push_back(t);
  if (is_below(shape, limits.flip_quality)) r.to_flip.push_back(t);
  if (is_below(shape, limits.smooth_quality)) r.to_smooth.push_back(t);
}

/// Counts the touched triangles at v and returns whether the ring of v needs no repair.
bool can_be_skipped(Rock& rock, int v, TouchedRegion& r) {
  const mesh::VertexStar& star = rock.surface.star(v);
  if (!has_spokes(star)) {
    r.asked += triangles_first_at(rock, v);
    return false;
  }
  const RingMarks marks = marks_around(rock, v);
  r.asked += triangles_first_at(star, marks);
  return r.fine_rings == RingSkipping::passed_over && ring_is_fine(rock, v, marks);
}

/// Marks both triangles of every pair that lies back to back. Each pair is tested once.
void find_folds(const mesh::Surface& s, TouchedRegion& r) {
  for (std::size_t k = 0; k < r.triangles.size(); ++k) {
    const int t = r.triangles[k];
    for (int c = 3 * t; c < 3 * t + 3; ++c) {
      const int o = s.opposite_of(c);
      if (o < 0) continue;
      const int other = place_of(r, o / 3);
      if (other >= 0 && at(other) < k) continue;
      const Vec3 area = other >= 0 ? r.areas[at(other)] : doubled_area(facet_at(s, o));
      if (!are_folded(r.areas[k], area)) continue;
      r.wants_collapse[k] = 1;
      if (other >= 0) r.wants_collapse[at(other)] = 1;
    }
  }
}

}  // namespace

Shape shape_of(const mesh::Surface& s, int t) {
  const mesh::Facet f = facet_at(s, 3 * t);
  const Vec3 ab = f.b - f.a, ac = f.c - f.a, bc = f.c - f.b;
  Shape shape{{bc.squaredNorm(), ac.squaredNorm(), ab.squaredNorm()}, 0.0, ab.cross(ac)};
  const double sum = shape.edge2[0] + shape.edge2[1] + shape.edge2[2];
  if (sum > 0.0) shape.quality2 = 12.0 * shape.doubled_area.squaredNorm() / (sum * sum);
  return shape;
}

void classify_touched_triangles(Rock& rock, const MaintenanceLimits& limits,
                                TouchedRegion& region) {
  const mesh::Surface& s = rock.surface;
  region.place.resize(s.triangles.size(), 0);
  clear(region);
  for (const int v : rock.touched_list) {
    rock.touched[at(v)] = classified_mark;
    if (!s.is_alive(v) || can_be_skipped(rock, v, region)) continue;
    mesh::visit_corners(s, v, [&](int c) {
      if (place_of(region, c / 3) < 0) classify(s, limits, c / 3, region);
    });
  }
  if (limits.worst_quality > 0.0) find_folds(s, region);
  for (std::size_t k = 0; k < region.triangles.size(); ++k)
    if (region.wants_collapse[k] != 0) region.to_collapse.push_back(region.triangles[k]);
}

void find_changed(const Rock& rock, TouchedRegion& region) {
  region.changed.clear();
  for (const int v : rock.touched_list)
    if (rock.touched[at(v)] == touched_mark) region.changed.push_back(v);
}

namespace {

bool is_folded_at(const mesh::Surface& s, const MaintenanceLimits& limits, int v) {
  bool found = false;
  mesh::visit_corners(s, v, [&](int c) { found = found || is_turned_over(s, limits, c / 3); });
  return found;
}

}  // namespace

bool is_due(const Rock& rock, const MaintenanceLimits& limits, int v) {
  return wait_is_over(rock, limits, v) || is_folded_at(rock.surface, limits, v);
}

void defer_vertices(Rock& rock, const MaintenanceLimits& limits, std::vector<int>& waiting) {
  waiting.resize(rock.touched_list.size());
  std::size_t kept = 0, waits = 0;
  for (const int v : rock.touched_list) {
    const bool is_alive = rock.surface.is_alive(v);
    if (is_alive &&
        (wait_is_over(rock, limits, v) || is_turned_over_at(rock.surface, limits, v, rock.notes))) {
      rock.touched_list[kept++] = v;
      continue;
    }
    rock.touched[at(v)] = 0;
    if (is_alive) waiting[waits++] = v;
  }
  rock.touched_list.resize(kept);
  waiting.resize(waits);
}

void relist_deferred(Rock& rock, const MaintenanceLimits& limits, const std::vector<int>& waiting) {
  for (const int v : rock.touched_list) rock.touched[at(v)] = 0;
  rock.touched_list.resize(waiting.size());
  std::size_t listed = 0;
  for (const int v : waiting) {  // a new vertex in the slot of a deleted one does not wait
    if (!rock.surface.is_alive(v) || wait_is_over(rock, limits, v)) continue;
    rock.touched[at(v)] = touched_mark;  // not by touch(), because the vertex did not change
    rock.touched_list[listed++] = v;
  }
  rock.touched_list.resize(listed);
}

void scale_cut_counts(Rock& rock, int parts) {
  rock.cuts *= parts;
  for (MovedIn& moved : rock.moved_in)
    for (int* cut : {&moved.first, &moved.last})
      if (*cut != MovedIn::never) *cut *= parts;
}

}  // namespace tdbd::rock
