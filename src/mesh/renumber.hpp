#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface.hpp"

namespace tdbd::mesh {

/// Buffers for renumber, reused between calls so that later calls allocate nothing.
struct RenumberRoom {
  std::vector<int> number;         ///< per old vertex: its new number, -1 if it is dead
  std::vector<int> first_corners;  ///< per new triangle: the old corner that becomes its first
  std::vector<int> ends;  ///< per new vertex: end of the triangles of which it is the smallest
  std::vector<int> corner_number;  ///< per old corner: its new number, if its triangle is alive
  std::vector<int> corners;
  std::vector<VertexStar> stars;
  std::vector<Triangle> triangles;
  std::vector<std::uint8_t> bytes;
};

/// Renumbers the vertices of a surface: vertex order[i] becomes i. `order` contains every living
/// vertex once. Triangles are numbered by their smallest vertex, then by the vertex that follows
/// it, and start with the smallest; corner_of is the first corner at each vertex. The result is
/// what make_surface builds from the same triangles; it does not depend on the previous numbers or
/// on the order of edits. No dead entry is left. `room.number` receives the new numbers.
void renumber(Surface& s, const std::vector<int>& order, RenumberRoom& room);

/// Permutes `values`: entry order[i] becomes entry i, and entries not listed are removed. `room`
/// swaps its memory with `values`.
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
