#pragma once

#include <optional>

#include "rock/cut/cutting_bit.hpp"
#include "rock/cut/near_planes.hpp"
#include "rock/cut/swept_convex.hpp"
#include "rock/cut/swept_mesh.hpp"

namespace tdbd::rock {

/// Room for one query of either kind.
struct SweptScratch {
  PlaneStrip convex;
  MeshScratch mesh;
  NearPlanes near;
};

/// The queries of swept_convex.hpp and swept_mesh.hpp, by what the part is; at the part's depth.
bool is_swept(const CuttingPart& part, const RelativePath& path, SweptScratch& scratch);
std::optional<double> exit_distance(const CuttingPart& part, const RelativePath& path,
                                    SweptScratch& scratch);

/// Prepares for the exits of all these paths from one part; then each exit, the same as
/// exit_distance gives.
void prepare_exits(const CuttingPart& part, const std::vector<RelativePath>& paths,
                   SweptScratch& scratch);
std::optional<double> prepared_exit_distance(const CuttingPart& part, const RelativePath& path,
                                             SweptScratch& scratch);

/// How deep x lies inside (m, to the nearest face); 0 or less outside.
double depth_inside(const CuttingPart& part, const Vec3& x_P);

}  // namespace tdbd::rock
