#include "rock/maintain/untangle.hpp"

#include <algorithm>
#include <limits>

#include "core/sort_unique.hpp"
#include "mesh/edit.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/ring_notes.hpp"

namespace tdbd::rock {
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
