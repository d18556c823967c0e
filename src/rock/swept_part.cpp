#include "rock/swept_part.hpp"

#include "mesh/inside.hpp"

namespace tdbd::rock {

bool is_swept(const CuttingPart& part, const RelativePath& path, SweptScratch& scratch) {
  return part.tree_P ? is_swept(*part.tree_P, path, part.depth, scratch.mesh)
                     : is_swept(part.solid_P, path, part.depth);
}

std::optional<double> exit_distance(const CuttingPart& part, const RelativePath& path,
                                    SweptScratch& scratch) {
  return part.tree_P ? exit_distance(*part.tree_P, path, part.depth, scratch.mesh)
                     : exit_distance(part.solid_P, path, part.depth, scratch.convex);
}

double depth_inside(const CuttingPart& part, const Vec3& x_P) {
  if (!part.tree_P) return depth_inside(part.solid_P, x_P);
  return mesh::inside(*part.tree_P, x_P) ? mesh::distance(*part.tree_P, x_P) : 0.0;
}

}  // namespace tdbd::rock
