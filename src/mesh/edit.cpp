#include "mesh/edit.hpp"

#include <initializer_list>

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
void cut_loose(Surface& s, int c) {
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
  for (int k = 3 * t; k < 3 * t + 3; ++k) cut_loose(s, k);
  free_triangle(s, t);
  s.boundary[at(apex)] = is_ear ? 0 : 1;
  if (is_ear) {
    s.corner_of[at(apex)] = -1;
    s.free_vertices.push_back(apex);
  }
  refresh({corners[0], corners[1], corners[2]}, s);
  return is_ear ? apex : -1;
}

}  // namespace tdbd::mesh
