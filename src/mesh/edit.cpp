#include "mesh/edit.hpp"

#include <algorithm>
#include <initializer_list>
#include <numeric>

namespace tdbd::mesh {
namespace {

void link(Surface& s, int c, int d) {
  if (c >= 0) s.opposite[at(c)] = d;
  if (d >= 0) s.opposite[at(d)] = c;
}

void set_vertex(Surface& s, int c, int v) { s.triangles[at(c / 3)][at(c % 3)] = v; }

int new_vertex(Surface& s, const Vec3& x) {
  int v = s.vertex_slots();
  if (s.free_vertices.empty()) {
    s.stars.emplace_back().x = x;
    s.corner_of.push_back(-1);
    s.boundary.push_back(0);
    return v;
  }
  v = s.free_vertices.back();
  s.free_vertices.pop_back();
  s.place(v, x);
  s.boundary[at(v)] = 0;
  return v;
}

int new_triangle(Surface& s, const Triangle& t) {
  int k = s.triangle_slots();
  if (s.free_triangles.empty()) {
    s.triangles.push_back(t);
    s.opposite.insert(s.opposite.end(), 3, -1);
    return k;
  }
  k = s.free_triangles.back();
  s.free_triangles.pop_back();
  s.triangles[at(k)] = t;
  return k;
}

void free_triangle(Surface& s, int t) {
  s.triangles[at(t)] = {-1, -1, -1};
  s.free_triangles.push_back(t);
}

/// Splits one side: the triangle (p, a, b) of corner c keeps (p, a, m); the new one is (p, m, b).
/// Returns the new triangle's corner at p.
int split_side(Surface& s, int c, int m) {
  const int n = next_corner(c), r = previous_corner(c);
  const int p = s.vertex(c), b = s.vertex(r);
  const int beyond = s.opposite_of(n);
  const int c1 = 3 * new_triangle(s, {p, m, b});
  set_vertex(s, r, m);
  link(s, c1 + 1, beyond);
  link(s, n, c1 + 2);
  s.corner_of[at(b)] = c1 + 2;
  return c1;
}

void refresh(std::initializer_list<int> vertices, Surface& s) {
  for (const int v : vertices) refresh_star(s, v);
}

/// Updates the stars of the neighbours of v. The star of v must be up to date.
void refresh_around(int v, Surface& s) {
  const VertexStar& star = s.star(v);
  for (int i = 0; i < star.size; ++i) refresh_star(s, s.ring(star)[i]);
}

int valence(const Surface& s, int v) {
  int n = 0;
  visit_corners(s, v, [&](int) { ++n; });
  return n;
}

bool are_neighbours(const Surface& s, int v, int w) {
  bool found = false;
  visit_corners(s, v, [&](int c) {
    found = found || s.vertex(next_corner(c)) == w || s.vertex(previous_corner(c)) == w;
  });
  return found;
}

/// Removes the triangle of corner c and links the triangles beyond its other two edges to each
/// other.
void close_gap(Surface& s, int c, int keep) {
  const int beyond_next = s.opposite_of(next_corner(c));
  const int beyond_previous = s.opposite_of(previous_corner(c));
  const int apex = s.vertex(c);
  if (beyond_next >= 0)
    link(s, beyond_next, beyond_previous);
  else
    link(s, beyond_previous, -1);
  // `side` is a corner that faces the edge (keep, apex); the other two corners of its triangle are
  // at these vertices.
  const int side = beyond_previous >= 0 ? beyond_previous : beyond_next;
  const int n = next_corner(side), r = previous_corner(side);
  s.corner_of[at(apex)] = s.vertex(n) == apex ? n : r;
  s.corner_of[at(keep)] = s.vertex(n) == apex ? r : n;
  free_triangle(s, c / 3);
}

/// Returns the corner of t that faces its only boundary edge or its only inner edge, or -1 if there
/// is neither.
int odd_corner(const Surface& s, int t) {
  int boundary = 0, sum_of_boundary = 0;
  for (int i = 0; i < 3; ++i)
    if (s.opposite_of(3 * t + i) < 0) {
      ++boundary;
      sum_of_boundary += i;
    }
  if (boundary == 1) return 3 * t + sum_of_boundary;
  return boundary == 2 ? 3 * t + 3 - sum_of_boundary : -1;
}

/// Detaches the triangle of corner c along the edge that c faces. The ends of that edge then refer
/// to corners of the triangle beyond.
void detach_triangle(Surface& s, int c) {
  const int o = s.opposite_of(c);
  if (o < 0) return;
  link(s, o, -1);
  for (const int k : {next_corner(o), previous_corner(o)}) s.corner_of[at(s.vertex(k))] = k;
}

}  // namespace

int split_edge(Surface& s, int c, const Vec3& x) {
  const int o = s.opposite_of(c);
  const int a = s.vertex(next_corner(c)), b = s.vertex(previous_corner(c));
  const int m = new_vertex(s, x);
  const int c1 = split_side(s, c, m);
  const int o1 = split_side(s, o, m);
  link(s, c, o1);
  link(s, c1, o);
  s.corner_of[at(m)] = previous_corner(c);
  s.corner_of[at(a)] = next_corner(c);
  refresh({m, a, b, s.vertex(c), s.vertex(o)}, s);
  return m;
}

bool collapse_keeps_topology(const Surface& s, int c) {
  const int o = s.opposite_of(c);
  if (o < 0) return false;
  const int a = s.vertex(next_corner(c)), b = s.vertex(previous_corner(c));
  const int p = s.vertex(c), q = s.vertex(o);
  if (s.is_boundary(b) || p == q) return false;
  if ((!s.is_boundary(p) && valence(s, p) <= 3) || (!s.is_boundary(q) && valence(s, q) <= 3))
    return false;
  bool only_two = true;
  visit_corners(s, b, [&](int k) {
    const int w = s.vertex(next_corner(k));
    if (w != a && w != p && w != q && are_neighbours(s, w, a)) only_two = false;
  });
  return only_two;
}

void collapse_edge(Surface& s, int c, const Vec3& x) {
  const int o = s.opposite_of(c);
  const int a = s.vertex(next_corner(c)), b = s.vertex(previous_corner(c));
  const int first = s.corner_of[at(b)];
  int k = first;
  do {  // b is interior, so the loop around it closes; links are unchanged while b is renamed
    const int following = turn_left(s, k);
    set_vertex(s, k, a);
    k = following;
  } while (k != first);
  close_gap(s, c, a);
  close_gap(s, o, a);
  s.place(a, x);
  s.corner_of[at(b)] = -1;
  s.free_vertices.push_back(b);
  refresh({a, b}, s);
  refresh_around(a, s);
}

bool flip_keeps_topology(const Surface& s, int c) {
  const int o = s.opposite_of(c);
  return o >= 0 && s.vertex(c) != s.vertex(o) && !are_neighbours(s, s.vertex(c), s.vertex(o));
}

void flip_edge(Surface& s, int c) {
  const int o = s.opposite_of(c);
  const int at_a = next_corner(c), at_b = next_corner(o);
  const int beyond_pb = s.opposite_of(at_a), beyond_qa = s.opposite_of(at_b);
  s.corner_of[at(s.vertex(at_a))] = at_a;
  s.corner_of[at(s.vertex(at_b))] = at_b;
  set_vertex(s, previous_corner(c), s.vertex(o));
  set_vertex(s, previous_corner(o), s.vertex(c));
  link(s, c, beyond_qa);
  link(s, o, beyond_pb);
  link(s, at_a, at_b);
  refresh({s.vertex(at_a), s.vertex(at_b), s.vertex(c), s.vertex(o)}, s);
}

bool removal_keeps_disc(const Surface& s, int t) {
  const int c = odd_corner(s, t);
  return c >= 0 && (s.opposite_of(c) >= 0 || !s.is_boundary(s.vertex(c)));
}

int remove_triangle(Surface& s, int t) {
  const int c = odd_corner(s, t);
  const int apex = s.vertex(c);
  const Triangle corners = s.triangles[at(t)];
  const bool is_ear = s.opposite_of(c) >= 0;
  for (int k = 3 * t; k < 3 * t + 3; ++k) detach_triangle(s, k);
  free_triangle(s, t);
  s.boundary[at(apex)] = is_ear ? 0 : 1;
  if (is_ear) {
    s.corner_of[at(apex)] = -1;
    s.free_vertices.push_back(apex);
  }
  refresh({corners[0], corners[1], corners[2]}, s);
  return is_ear ? apex : -1;
}

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
void order_triangles(const Surface& s, std::size_t vertices, RenumberScratch& scratch) {
  const auto number_at = [&](int c) { return scratch.number[at(s.vertex(c))]; };
  const auto visit = [&](auto&& act) {
    for (int t = 0; t < s.triangle_slots(); ++t)
      if (s.triangle_is_alive(t)) act(least_corner(s, t, scratch.number));
  };
  std::vector<int>& ends = scratch.ends;  // counts, then starts, then ends
  ends.assign(vertices, 0);
  visit([&](int c) { ++ends[at(number_at(c))]; });
  std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), 0);
  scratch.first_corners.resize(at(s.triangle_count()));
  visit([&](int c) { scratch.first_corners[at(ends[at(number_at(c))]++)] = c; });
  auto first = scratch.first_corners.begin();
  for (const int end : ends) {
    const auto last = scratch.first_corners.begin() + end;
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

void renumber_stars(Surface& s, const std::vector<int>& order, RenumberScratch& scratch) {
  take_in_order(order, s.stars, scratch.stars);
  for (VertexStar& star : s.stars) renumber_ring(s, star, scratch.number);
}

void renumber_triangles(Surface& s, RenumberScratch& scratch) {
  scratch.triangles.reserve(s.triangles.capacity());
  scratch.triangles.clear();
  scratch.corner_number.resize(s.opposite.size());
  int new_corner = 0;
  for (const int c : scratch.first_corners) {
    Triangle t{};
    int old = c;
    for (int& v : t) {
      v = scratch.number[at(s.vertex(old))];
      scratch.corner_number[at(old)] = new_corner++;
      old = next_corner(old);
    }
    scratch.triangles.push_back(t);
  }
  s.triangles.swap(scratch.triangles);
}

/// Requires triangles that are already renumbered.
void renumber_opposites(Surface& s, RenumberScratch& scratch) {
  scratch.corners.reserve(s.opposite.capacity());
  scratch.corners.clear();
  for (int c : scratch.first_corners)
    for (int i = 0; i < 3; ++i, c = next_corner(c)) {
      const int o = s.opposite_of(c);
      scratch.corners.push_back(o < 0 ? -1 : scratch.corner_number[at(o)]);
    }
  s.opposite.swap(scratch.corners);
}

void reset_first_corners(Surface& s) {
  s.corner_of.resize(s.stars.size());
  for (int c = 3 * s.triangle_slots() - 1; c >= 0; --c) s.corner_of[at(s.vertex(c))] = c;
}

}  // namespace

void renumber(Surface& s, const std::vector<int>& order, RenumberScratch& scratch) {
  number_vertices(s, order, scratch.number);
  order_triangles(s, order.size(), scratch);
  renumber_stars(s, order, scratch);
  take_in_order(order, s.boundary, scratch.bytes);
  renumber_triangles(s, scratch);
  renumber_opposites(s, scratch);
  s.free_vertices.clear();
  s.free_triangles.clear();
  reset_first_corners(s);
}

}  // namespace tdbd::mesh
