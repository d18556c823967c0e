#pragma once

#include <rapidcheck.h>

#include "bit/bit.hpp"
#include "core/types.hpp"
#include "rock/cut/cut_rock.hpp"

/// Random cuts: some convex parts and one step of their motion over a bumpy sheet of rock.
namespace tdbd::rock {

/// What a step starts from. Lengths in m; the rock is the square [-1.5, 1.5]^2 near z = 0.
struct Scene {
  bit::Bit bit;
  Pose X_WB0, X_WB1;
  mesh::TriangleMesh rock_W;
};

/// How wild the scenes are.
struct Wildness {
  int most_parts = 4;
  double tilt = 0.2;      ///< rad, of the bit's axis against the vertical
  double turn = 0.1;      ///< rad, in the step
  double outwards = 1.2;  ///< rad, largest angle of update directions against straight down
  double bump = 0.2;      ///< cells, of the rock
};

/// Parts are hulls, boxes and discs of 0.1 to 0.4, above, across and below the rock's surface, some
/// in groups, and stay clear of the rock's boundary.
rc::Gen<Scene> scene(const Wildness& w = {});

/// The scene's rock under its index.
Rock rock_of(const Scene& s);

/// How deep x is behind the planes of a convex mesh's triangles, m; negative outside.
double depth_behind_triangles(const mesh::TriangleMesh& convex, const Vec3& x);

}  // namespace tdbd::rock
