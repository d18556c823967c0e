#include "mesh/renumber.hpp"

#include <algorithm>
#include <numeric>

namespace tdbd::mesh {
namespace {

void number_vertices(const Surface& s, const std::vector<int>& order, std::vector<int>& number) {
  number.assign(s.stars.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) number[at(order[i])] = static_cast<int>(i);
}

/// The corner of triangle t at the vertex with the smallest new number.
int least_corner(const Surface& s, int t, const std::vector<int>& number) {
  const auto& [a, b, c] = s.triangles[at(t)];
  const int na = number[at(a)], nb = number[at(b)], nc = number[at(c)];
  if (na < nb) return 3 * t + (na < nc ? 0 : 2);
  return 3 * t + (nb < nc ? 1 : 2);
}

/// Counting sort of the triangles by their smallest vertex. Triangles with the same smallest vertex
/// are sorted by the vertex that follows it.
void order_triangles(const Surface& s, std::size_t vertices, RenumberRoom& room) {
  const auto number_at = [&](int c) { return room.number[at(s.vertex(c))]; };
  const auto visit = [&](auto&& act) {
    for (int t = 0; t < s.triangle_slots(); ++t)
      if (s.triangle_is_alive(t)) act(least_corner(s, t, room.number));
  };
  std::vector<int>& ends = room.ends;  // counts, then starts, then ends
  ends.assign(vertices, 0);
  visit([&](int c) { ++ends[at(number_at(c))]; });
  std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), 0);
  room.first_corners.resize(at(s.triangle_count()));
  visit([&](int c) { room.first_corners[at(ends[at(number_at(c))]++)] = c; });
  auto first = room.first_corners.begin();
  for (const int end : ends) {
    const auto last = room.first_corners.begin() + end;
    if (last - first > 1)
      std::sort(first, last, [&](int c, int d) {
        return number_at(next_corner(c)) < number_at(next_corner(d));
      });
    first = last;
  }
}

/// Replaces the neighbours by their new numbers. A closed ring starts with its smallest.
void renumber_ring(Surface& s, VertexStar& star, const std::vector<int>& number) {
  int* ring = star.long_ring < 0 ? star.ring.data() : s.long_rings[at(star.long_ring)].data();
  int* end = ring + star.size;
  for (int* w = ring; w != end; ++w) *w = number[at(*w)];
  if (star.open == 0) std::rotate(ring, std::min_element(ring, end), end);
}

void renumber_stars(Surface& s, const std::vector<int>& order, RenumberRoom& room) {
  take_in_order(order, s.stars, room.stars);
  for (VertexStar& star : s.stars) renumber_ring(s, star, room.number);
}

void renumber_triangles(Surface& s, RenumberRoom& room) {
  room.triangles.reserve(s.triangles.capacity());
  room.triangles.clear();
  room.corner_number.resize(s.opposite.size());
  int new_corner = 0;
  for (const int c : room.first_corners) {
    Triangle t{};
    int old = c;
    for (int& v : t) {
      v = room.number[at(s.vertex(old))];
      room.corner_number[at(old)] = new_corner++;
      old = next_corner(old);
    }
    room.triangles.push_back(t);
  }
  s.triangles.swap(room.triangles);
}

/// Requires triangles that are already renumbered.
void renumber_opposites(Surface& s, RenumberRoom& room) {
  room.corners.reserve(s.opposite.capacity());
  room.corners.clear();
  for (int c : room.first_corners)
    for (int i = 0; i < 3; ++i, c = next_corner(c)) {
      const int o = s.opposite_of(c);
      room.corners.push_back(o < 0 ? -1 : room.corner_number[at(o)]);
    }
  s.opposite.swap(room.corners);
}

void hold_first_corners(Surface& s) {
  s.corner_of.resize(s.stars.size());
  for (int c = 3 * s.triangle_slots() - 1; c >= 0; --c) s.corner_of[at(s.vertex(c))] = c;
}

}  // namespace

void renumber(Surface& s, const std::vector<int>& order, RenumberRoom& room) {
  number_vertices(s, order, room.number);
  order_triangles(s, order.size(), room);
  renumber_stars(s, order, room);
  take_in_order(order, s.boundary, room.bytes);
  renumber_triangles(s, room);
  renumber_opposites(s, room);
  s.free_vertices.clear();
  s.free_triangles.clear();
  hold_first_corners(s);
}

}  // namespace tdbd::mesh
