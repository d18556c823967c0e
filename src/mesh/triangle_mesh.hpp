#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace tdbd::mesh {

using Triangle = std::array<int, 3>;

/// A triangle mesh as in files and parts. Triangles are counter-clockwise seen from outside, where
/// the normal points. Positions in m, in the frame that the owner states.
struct TriangleMesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};

inline const Vec3& position(const TriangleMesh& m, int v) { return m.positions[at(v)]; }

/// The positions of the corners of triangle i.
inline std::array<Vec3, 3> corners(const TriangleMesh& m, std::size_t i) {
  const Triangle& t = m.triangles[i];
  return {m.positions[at(t[0])], m.positions[at(t[1])], m.positions[at(t[2])]};
}

/// A body of a mesh file.
struct Solid {
  std::string name;
  TriangleMesh mesh;  ///< positions in m
};

}  // namespace tdbd::mesh
