#include "rock/cut/swept_part.hpp"

#include "core/tolerance.hpp"
#include "mesh/search/inside.hpp"

namespace tdbd::rock {

bool is_swept(const CuttingPart& part, const RelativePath& path, SweptScratch& scratch) {
  return part.tree_P ? is_swept(*part.tree_P, path, part.depth, scratch.mesh)
                     : is_swept(part.solid_P, path, part.depth);
}

std::optional<double> exit_distance(const CuttingPart& part, const RelativePath& path,
                                    SweptScratch& scratch) {
  if (!part.across.empty())
    return exit_distance_by_walk(*part.tree_P, part.across, path, part.depth, scratch.mesh);
  return part.tree_P ? exit_distance(*part.tree_P, path, part.depth, scratch.mesh)
                     : exit_distance(part.solid_P, path, part.depth, scratch.convex);
}

void prepare_exits(const CuttingPart& part, const std::vector<RelativePath>& paths,
                   SweptScratch& scratch) {
  if (part.tree_P) return;
  constexpr double usual_exit = 0.1;  // of the part's size; farther exits use the whole part
  find_near_planes(part.solid_P, paths, part.depth, usual_exit * part.depth / tolerance::swept,
                   scratch.near);
}

std::optional<double> prepared_exit_distance(const CuttingPart& part, const RelativePath& path,
                                             SweptScratch& scratch) {
  if (part.tree_P || scratch.near.solid_P.planes == 0) return exit_distance(part, path, scratch);
  const auto t = exit_distance(scratch.near.solid_P, path, part.depth, scratch.convex);
  if (t && *t > scratch.near.t_max) return exit_distance(part, path, scratch);
  return t;
}

double depth_inside(const CuttingPart& part, const Vec3& x_P) {
  if (!part.tree_P) return depth_inside(part.solid_P, x_P);
  return mesh::inside(*part.tree_P, x_P) ? mesh::distance(*part.tree_P, x_P) : 0.0;
}

}  // namespace tdbd::rock
