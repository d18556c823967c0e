#pragma once

#include <limits>
#include <optional>

#include "core/types.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/cutting_bit.hpp"
#include "rock/cut/plane_strip.hpp"
#include "rock/cut/swept_mesh.hpp"

namespace tdbd::rock {

/// A place is on a plane if its distance is at most this, m.
inline constexpr double corner_tolerance = 1e-11;

/// A ray touches the solid if it enters at most this much after it leaves, m.
inline constexpr double entry_tolerance = 1e-12;

/// Depth of x inside the solid (m, to the nearest plane); negative outside.
double depth_inside(const mesh::ConvexSolid& solid, const Vec3& x_P);

/// Whether the path of the vertex itself enters the solid by more than `depth` (m), rock (2).
bool is_swept(const mesh::ConvexSolid& solid, const RelativePath& path, double depth);

/// Returns the exit of a swept vertex: the largest t >= 0 for which some tau puts q(tau) + t u(tau)
/// inside the solid, that tau, and the plane through which the vertex leaves. Returns nothing if
/// the vertex is not swept. The search stops at a place with t >= `t_max`, which need not be the
/// exit. Below t_max the result is bitwise independent of planes that the path cannot reach within
/// t_max (plane_strip.hpp). See rock (3), (4). Thesis: 4.1.3.3 (reconstructed). Twins:
/// reference/rock/exit_by_corners and, for any mesh, brute_force_exit.
std::optional<Crossing> find_exit(const mesh::ConvexSolid& solid, const RelativePath& path,
                                  double depth, PlaneStrip& strip,
                                  double t_max = std::numeric_limits<double>::infinity());

/// The t of find_exit.
std::optional<double> exit_distance(const mesh::ConvexSolid& solid, const RelativePath& path,
                                    double depth, PlaneStrip& strip);

/// Buffers of queries for convex parts and meshes.
struct SweptScratch {
  MeshScratch mesh;
  std::vector<NearPlanes> near;  ///< per CuttingPart::slot, kept from step to step
};

/// The queries of swept_part.hpp or swept_mesh.hpp, as the part requires, at the part's depth.
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

/// How far a vertex moves, and through the surface of which part of its group it leaves.
struct UnionExit {
  std::size_t part;  ///< index into CuttingGroup::parts
  double t;          ///< m, > 0
};

/// Converts a crossing of the whole's solid, with its planes numbered as there. Returns nothing if
/// the vertex does not move.
std::optional<UnionExit> union_exit(const CuttingUnion& whole, const RelativePath& path,
                                    const Crossing& x);

/// Returns the exit of a path for which prepare_exits was called with whole.solid. Nothing if the
/// whole does not sweep it.
std::optional<UnionExit> prepared_union_exit(const CuttingUnion& whole, const RelativePath& path,
                                             const SweptScratch& scratch);

}  // namespace tdbd::rock
