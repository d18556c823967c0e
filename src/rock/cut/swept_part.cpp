#include "rock/cut/swept_part.hpp"

#include <algorithm>

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
  if (part.tree_P) return exit_distance(*part.tree_P, path, part.depth, scratch.mesh);
  PlaneStrip strip;
  return exit_distance(part.solid_P, path, part.depth, strip);
}

void prepare_exits(const CuttingPart& part, const PathBoxes& boxes, SweptScratch& scratch) {
  if (part.tree_P) return;
  if (scratch.near.size() <= part.slot) scratch.near.resize(part.slot + 1);
  constexpr double usual_exit = 0.1;  // times the part's size; farther exits use all planes
  update_near_planes(part.solid_P, part.checksum, boxes, part.depth,
                     usual_exit * part.depth / tolerance::swept, scratch.near[part.slot]);
}

std::optional<Crossing> prepared_exit(const CuttingPart& part, const RelativePath& path,
                                      const SweptScratch& scratch) {
  const NearPlanes& near = scratch.near[part.slot];
  PlaneStrip strip;
  auto x = find_exit(near.solid_P, path, part.depth, strip, near.t_max);
  if (x && !(x->t < near.t_max)) return find_exit(part.solid_P, path, part.depth, strip);
  if (x) x->plane = near.plane[x->plane];
  return x;
}

std::optional<double> prepared_exit_distance(const CuttingPart& part, const RelativePath& path,
                                             SweptScratch& scratch) {
  if (part.tree_P) return exit_distance(part, path, scratch);
  const auto x = prepared_exit(part, path, scratch);
  return x ? std::optional(std::max(0.0, x->t)) : std::nullopt;
}

double depth_inside(const CuttingPart& part, const Vec3& x_P) {
  if (!part.tree_P) return depth_inside(part.solid_P, x_P);
  return mesh::inside(*part.tree_P, x_P) ? mesh::distance(*part.tree_P, x_P) : 0.0;
}

}  // namespace tdbd::rock
