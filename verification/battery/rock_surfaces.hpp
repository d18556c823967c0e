#pragma once

#include <cstdint>

#include "mesh/triangle_mesh.hpp"

/// Random sheets in place of rock. Lengths in m; the normal points out of the rock, towards -z.
namespace tdbd::battery {

/// The square [-half, half]^2 near z = 0 in n x n cells, each cut along a random diagonal. Inner
/// vertices are displaced by up to `bump` cells in every direction; the boundary is flat. For a
/// bump below 0.5 the sheet is the graph of a function wherever the diagonals allow it.
mesh::TriangleMesh bumpy_rock(double half, int n, double bump, std::uint64_t seed);

}  // namespace tdbd::battery
