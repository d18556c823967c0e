#include "rock/rock.hpp"

#include <utility>

namespace tdbd::rock {
namespace {

VertexGrid index_of(const mesh::Surface& surface, const mesh::Box& box_W, double cell) {
  VertexGrid grid(box_W, cell);
  std::vector<int> alive;
  for (int v = 0; v < surface.vertex_slots(); ++v)
    if (surface.is_alive(v)) alive.push_back(v);
  grid.insert_all(mesh::positions_of(surface), std::move(alive));
  return grid;
}

}  // namespace

Rock make_rock(mesh::Surface surface, double cell, const mesh::Box& reach_W) {
  Rock rock;
  mesh::Box box = reach_W;
  for (const mesh::VertexStar& star : surface.stars) box.add(star.x);
  rock.grid = index_of(surface, box, cell);
  rock.last_part.assign(surface.stars.size(), -1);
  rock.touched.assign(surface.stars.size(), 0);
  rock.moved_in.assign(surface.stars.size(), {});
  rock.surface = std::move(surface);
  return rock;
}

void rebuild_index(Rock& rock, const mesh::Box& box_W) {
  constexpr long never = -1;
  const double cell = rock.grid.cell();
  rock.grid = VertexGrid();  // before the new one is made: never two in memory
  rock.grid = index_of(rock.surface, box_W, cell);
  for (NearList& list : rock.near_lists) list.changes = never;
}

void deepen_index(Rock& rock) {
  constexpr double cells_below = 4.0;
  const mesh::Box old = rock.grid.box();
  if (rock.grid.deepest() <= old.hi.z() + cells_below * rock.grid.cell()) return;
  mesh::Box box;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if (rock.surface.is_alive(v)) box.add(rock.surface.position(v));
  box.hi.z() += box.size().z();
  box.lo.head<2>() = box.lo.head<2>().cwiseMin(old.lo.head<2>());
  box.hi.head<2>() = box.hi.head<2>().cwiseMax(old.hi.head<2>());
  rebuild_index(rock, box);
}

void touch(Rock& rock, int v) {
  discard_ring_note(rock, v);
  std::uint8_t& mark = rock.touched[at(v)];
  const bool is_listed = mark != 0;
  mark = touched_mark;
  if (is_listed) return;
  rock.touched_list.push_back(v);
}

void mark_neighbours_changed(Rock& rock, int v) {
  mesh::visit_corners(rock.surface, v,
                      [&](int c) { touch(rock, rock.surface.vertex(mesh::next_corner(c))); });
}

void place_vertex(Rock& rock, int v, const Vec3& x_W, Notify notify) {
  rock.surface.place(v, x_W);
  rock.grid.move(v, x_W, notify);
  touch(rock, v);
}

void record_cut(Rock& rock, int v) {
  MovedIn& moved = rock.moved_in[at(v)];
  if (rock.touched[at(v)] == 0) moved.first = rock.cuts;
  moved.last = rock.cuts;
}

void register_vertex(Rock& rock, int v, int last_part) {
  const std::size_t n = at(rock.surface.vertex_slots());
  rock.last_part.resize(n, -1);
  rock.touched.resize(n, 0);
  rock.moved_in.resize(n);
  rock.notes.of.resize(n, 0);
  rock.moved_in[at(v)] = {};
  rock.last_part[at(v)] = last_part;
  rock.grid.insert(v, rock.surface.position(v));
}

}  // namespace tdbd::rock
