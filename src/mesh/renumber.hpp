#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface.hpp"

namespace tdbd::mesh {

/// Room for renumberings, kept between them so that none allocates once warm.
struct RenumberRoom {
  std::vector<int> number;         ///< per old vertex: its new number, -1 if it is dead
  std::vector<int> first_corners;  ///< per new triangle: the old corner that becomes its first
  std::vector<int> ends;  ///< per new vertex: where the triangles end that it is the least of
  std::vector<int> corner_number;  ///< per old corner: its new number, if its triangle is alive
  std::vector<int> corners;
  std::vector<VertexStar> stars;
  std::vector<Triangle> triangles;
  std::vector<std::uint8_t> bytes;
};

/// Gives the vertices of a surface new numbers: vertex order[i] becomes i. `order` lists the living ones, each once.
/// Triangles are numbered by their least vertex, then by the one that follows it, and begin with the least; of each
/// vertex the first corner is held. So the surface is afterwards what make_surface builds of its own triangles, whatever
/// its numbers were and in which order it was edited. No dead entry is left. `room.number` receives the new numbers.
void renumber(Surface& s, const std::vector<int>& order, RenumberRoom& room);

/// Entry order[i] becomes i, and what is not listed goes. `room` exchanges its memory with `values`.
template <class T>
void take_in_order(const std::vector<int>& order, std::vector<T>& values, std::vector<T>& room) {
  room.reserve(values.capacity());
  room.resize(order.size());
  constexpr std::size_t farther = 16;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i + farther < order.size()) __builtin_prefetch(&values[at(order[i + farther])]);
    room[i] = values[at(order[i])];
  }
  values.swap(room);
}

}  // namespace tdbd::mesh
