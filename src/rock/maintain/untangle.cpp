#include "rock/maintain/untangle.hpp"

#include <algorithm>
#include <limits>

#include "core/sort_unique.hpp"
#include "mesh/edit.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/touched_region.hpp"

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

namespace {

bool may_fold(const mesh::Surface& s, int v, RingNotes& notes) {
  return (note_at(s, v, notes) & ring_may_fold) != 0;
}

/// Whether a triangle at v may be turned over: a triangle leans at v, and another triangle at one
/// of its corners may be turned against it.
bool may_be_turned_over_at(const mesh::Surface& s, int v, RingNotes& notes) {
  const unsigned note = note_at(s, v, notes);
  if ((note & ring_may_fold) != 0) return true;
  const unsigned leaning = note >> first_leaning_bit;
  if (leaning == 0) return false;
  const mesh::VertexStar& star = s.star(v);
  const unsigned ends = leaning | leaning << 1U | leaning >> (star.size - 1U);
  for (unsigned i = 0; i < star.size; ++i)
    if ((ends >> i & 1U) != 0 && may_fold(s, star.ring[i], notes)) return true;
  return false;
}

}  // namespace

bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t,
                    RingNotes& notes) {
  return std::ranges::any_of(s.triangles[at(t)], [&](int v) { return may_fold(s, v, notes); }) &&
         is_turned_over(s, limits, t);
}

bool is_turned_over_at(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                       RingNotes& notes) {
  if (!may_be_turned_over_at(s, v, notes)) return false;
  bool found = false;
  mesh::visit_corners(s, v,
                      [&](int c) { found = found || is_turned_over(s, limits, c / 3, notes); });
  return found;
}

void add_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                     RingNotes& notes, std::vector<int>& triangles) {
  if (!may_be_turned_over_at(s, v, notes)) return;
  mesh::visit_corners(s, v, [&](int c) {
    if (is_turned_over(s, limits, c / 3, notes)) triangles.push_back(c / 3);
  });
}

namespace {

using Work = MaintenanceWorkspace;

constexpr std::size_t all_pairs = std::numeric_limits<std::size_t>::max();

/// As for folds: without a limit on quality, only short edges collapse.
bool untangling_enabled(const MaintenanceLimits& limits) {
  return limits.untangle_farthest > 0.0 && limits.worst_quality > 0.0;
}

/// The limits of collapses that untangle.
MaintenanceLimits loosened(MaintenanceLimits l) {
  constexpr double any_normal = -1.0, any_overhang = 2.0;
  l.volume_per_operation = l.untangle_volume;
  l.farthest = l.untangle_farthest;
  l.ridge_cut = std::numeric_limits<double>::infinity();
  l.least_normal_cosine = any_normal;
  l.steepest_overhang = any_overhang;
  return l;
}

void add_edges_of(const mesh::Surface& s, const mesh::Triangle& v,
                  std::vector<EdgeCandidate>& edges) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int a = std::min(v[i], v[(i + 1) % 3]), b = std::max(v[i], v[(i + 1) % 3]);
    edges.push_back({(s.position(a) - s.position(b)).squaredNorm(), a, b});
  }
}

/// The edges of both triangles of every intersecting pair that includes a suspect.
void find_edges(const Rock& rock, const MaintenanceLimits& limits, Work& work) {
  const mesh::Surface& s = rock.surface;
  work.edges.clear();
  for (const int t : work.suspects) {
    if (!s.triangle_is_alive(t)) continue;
    take_triangle(s, t, work.patch);
    find_intersections(rock, work.patch, limits.longest_edge, all_pairs, work.intersections);
    for (const auto& [one, other] : work.intersections.met) {
      add_edges_of(s, one, work.edges);
      add_edges_of(s, other, work.edges);
    }
  }
  sort_edges(work.edges);
}

/// Number of intersecting pairs of the patch, at most `most`.
std::size_t count_pairs(const Rock& rock, const MaintenanceLimits& limits, std::size_t most,
                        Work& work) {
  find_intersections(rock, work.patch, limits.longest_edge, most, work.intersections);
  return work.intersections.met.size();
}

/// Collapses the edge to the first of its three places that leaves fewer intersecting pairs.
bool try_untangle(Rock& rock, int a, int b, const MaintenanceLimits& loose, Work& work,
                  MaintenanceReport& report) {
  const mesh::Surface& s = rock.surface;
  take_stars(s, {a, b}, work.patch);
  const std::size_t pairs = count_pairs(rock, loose, all_pairs, work);
  if (pairs == 0) return false;  // another collapse has separated them
  std::optional<Refusal> why;
  for (const CollapseVerdict& v : judge_collapses(s, a, b, loose, work.drift)) {
    if (v.corner < 0) return false;
    if (!why) why = v.refused;
    if (v.refused) continue;
    const int keep = s.vertex(mesh::next_corner(v.corner));
    take_collapsed(s, keep, keep == a ? b : a, v.x_W, work.patch);
    if (count_pairs(rock, loose, pairs, work) < pairs) {
      collapse(rock, v, Operation::untangling, work.ring, work.drift, report);
      return true;
    }
    why = Refusal::intersection;
  }
  count_refused(report, Operation::untangling, why.value_or(Refusal::intersection));
  return false;
}

/// Adds the triangles around the changed vertices, which may now pass through others.
void add_suspects(const mesh::Surface& s, const std::vector<int>& vertices, Work& work) {
  for (const int v : vertices)
    if (s.is_alive(v)) mesh::visit_corners(s, v, [&](int c) { work.suspects.push_back(c / 3); });
  sort_unique(work.suspects);
}

}  // namespace

std::vector<int> find_folded_places(Rock& rock, const MaintenanceLimits& limits, Work& work) {
  const mesh::Surface& s = rock.surface;
  std::vector<int> folded;
  if (!untangling_enabled(limits)) return folded;
  for (const int t : work.touched.steep)
    if (is_turned_over(s, limits, t, rock.notes)) {
      const mesh::Triangle& v = s.triangles[at(t)];
      folded.insert(folded.end(), v.begin(), v.end());
    }
  sort_unique(folded);
  return folded;
}

void find_suspects(Rock& rock, const std::vector<int>& folded, const MaintenanceLimits& limits,
                   Work& work) {
  const mesh::Surface& s = rock.surface;
  work.suspects.clear();
  find_changed(rock, work.touched);
  for (const int t : work.touched.steep)
    if (s.triangle_is_alive(t) && is_turned_over(s, limits, t, rock.notes))
      work.suspects.push_back(t);
  for (const int v : work.touched.changed)
    if (s.is_alive(v)) add_turned_over(s, limits, v, rock.notes, work.suspects);
  add_suspects(s, folded, work);
}

bool untangle(Rock& rock, const std::vector<int>& folded, const MaintenanceLimits& limits,
              Work& work, MaintenanceReport& report) {
  constexpr int most_rounds = 20;  // each round leaves fewer pairs
  work.region.clear();
  if (!untangling_enabled(limits)) return false;
  const MaintenanceLimits loose = loosened(limits);
  find_suspects(rock, folded, limits, work);
  for (int rounds = 0; rounds < most_rounds; ++rounds) {
    find_edges(rock, limits, work);
    const std::size_t done_before = work.region.size();
    for (const EdgeCandidate& e : work.edges)
      if (rock.surface.is_alive(e.a) && rock.surface.is_alive(e.b) &&
          try_untangle(rock, e.a, e.b, loose, work, report))
        work.region.insert(work.region.end(), work.ring.begin(), work.ring.end());
    if (work.region.size() == done_before) break;
    add_suspects(rock.surface, work.region, work);
  }
  sort_unique(work.region);
  return !work.region.empty();
}

}  // namespace tdbd::rock
