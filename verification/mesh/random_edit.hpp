#pragma once

#include "mesh/edit.hpp"

namespace tdbd::mesh {

/// One random edit of any kind, where the topology allows it.
inline void random_edit(Surface& s, int choice) {
  const int c = choice / 4 % (3 * s.triangle_slots());
  if (!s.triangle_is_alive(c / 3)) return;
  const bool is_inner = s.opposite_of(c) >= 0;
  const Vec3 x =
      0.5 * (s.position(s.vertex(next_corner(c))) + s.position(s.vertex(previous_corner(c))));
  if (choice % 4 == 0 && is_inner) split_edge(s, c, x);
  if (choice % 4 == 1 && is_inner && collapse_keeps_topology(s, c)) collapse_edge(s, c, x);
  if (choice % 4 == 2 && is_inner && flip_keeps_topology(s, c)) flip_edge(s, c);
  if (choice % 4 == 3 && removal_keeps_disc(s, c / 3)) remove_triangle(s, c / 3);
}

}  // namespace tdbd::mesh
