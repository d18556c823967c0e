#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace tdbd::mesh {

using Triangle = std::array<int, 3>;

/// Plain triangle mesh: what files hold and parts are made of. Triangles are counter-clockwise seen
/// from outside (from where the normal points). Positions in m, in the frame its owner names.
struct TriangleMesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};

}  // namespace tdbd::mesh
