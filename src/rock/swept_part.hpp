#pragma once

#include <optional>

#include "rock/cutting_bit.hpp"
#include "rock/swept_convex.hpp"
#include "rock/swept_mesh.hpp"

namespace tdbd::rock {

/// Room for one query of either kind.
struct SweptScratch {
  PlaneStrip convex;
  MeshScratch mesh;
};

/// The queries of swept_convex.hpp and swept_mesh.hpp, by what the part is; at the part's depth.
bool is_swept(const CuttingPart& part, const RelativePath& path, SweptScratch& scratch);
std::optional<double> exit_distance(const CuttingPart& part, const RelativePath& path,
                                    SweptScratch& scratch);

/// How deep x lies inside (m, to the nearest face); 0 or less outside.
double depth_inside(const CuttingPart& part, const Vec3& x_P);

}  // namespace tdbd::rock
