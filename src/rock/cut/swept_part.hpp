#pragma once

#include <optional>

#include "rock/cut/cutting_bit.hpp"
#include "rock/cut/near_planes.hpp"
#include "rock/cut/swept_convex.hpp"
#include "rock/cut/swept_mesh.hpp"

namespace tdbd::rock {

/// Buffers of queries for convex parts and meshes.
struct SweptScratch {
  MeshScratch mesh;
  std::vector<NearPlanes> near;  ///< per CuttingPart::slot, kept from step to step
};

/// The queries of swept_convex.hpp or swept_mesh.hpp, as the part requires, at the part's depth.
bool is_swept(const CuttingPart& part, const RelativePath& path, SweptScratch& scratch);
std::optional<double> exit_distance(const CuttingPart& part, const RelativePath& path,
                                    SweptScratch& scratch);

/// Prepares a part for exits of all paths in these boxes. Afterwards prepared_exit_distance gives
/// bitwise the same result as exit_distance, but faster.
void prepare_exits(const CuttingPart& part, const PathBoxes& boxes, SweptScratch& scratch);
std::optional<double> prepared_exit_distance(const CuttingPart& part, const RelativePath& path,
                                             SweptScratch& scratch);

/// Returns the same exit with its place and its plane of part.solid_P. Only for convex parts.
std::optional<Crossing> prepared_exit(const CuttingPart& part, const RelativePath& path,
                                      const SweptScratch& scratch);

/// Depth of x inside the part (m, to the nearest face); 0 or less outside.
double depth_inside(const CuttingPart& part, const Vec3& x_P);

}  // namespace tdbd::rock
