#include "rock/maintain/turned_over.hpp"

#include <algorithm>

#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/star.hpp"

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

}  // namespace tdbd::rock
