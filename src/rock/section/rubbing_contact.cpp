#include "rock/section/rubbing_contact.hpp"

#include <algorithm>
#include <array>

#include "core/parallel.hpp"
#include "mesh/search/inside.hpp"

namespace tdbd::rock {
namespace {

Region region_of(const mesh::Box& box_P, const Pose& X_WP) {
  Region region{};
  for (int i = 0; i < 3; ++i) {
    const Vec3 n_W = X_WP.R.col(i);
    const double at_origin = n_W.dot(X_WP.p);
    region.slabs[at(i)] = {n_W, at_origin + box_P.lo[i], at_origin + box_P.hi[i]};
  }
  region.box = box_around(region.slabs);
  return region;
}

void find_near(const Rock& rock, const RubbingPart& part, const Pose& X_WP, double edge,
               RubbingWork& w) {
  const Region region_W = widened(region_of(part.box_P, X_WP), edge);
  w.near.clear();
  rock.grid.visit(region_W, w.chains, [&](const VertexGrid::Block& block) {
    w.near.insert(w.near.end(), block.v.begin(), block.v.begin() + block.count);
  });
  std::ranges::sort(w.near);
  const Pose X_PW = inverse(X_WP);
  w.near_P.clear();
  w.slot.resize(rock.surface.stars.size(), -1);
  for (std::size_t i = 0; i < w.near.size(); ++i) {
    w.slot[at(w.near[i])] = static_cast<int>(i);
    w.near_P.push_back(X_PW * rock.surface.position(w.near[i]));
  }
}

void forget_near(RubbingWork& w) {
  for (const int v : w.near) w.slot[at(v)] = -1;
}

/// Signed distances of the near vertices from a part that is not convex: far outside only the sign is
/// right.
void find_depths(const RubbingPart& part, double edge, RubbingWork& w) {
  w.depth.assign(w.near.size(), -edge);
  parallel_for(static_cast<int>(w.near.size()), [&](int i) {
    const Vec3& x_P = w.near_P[at(i)];
    const double distance = mesh::distance_up_to(*part.tree_P, x_P, edge);
    const bool is_inside = part.box_P.contains(x_P) && mesh::inside(*part.tree_P, x_P);
    w.depth[at(i)] = is_inside ? distance : -distance;
  });
}

/// Keeps the part of a polygon where `depth`, linear along its edges, is positive or zero.
template <class Depth>
void clip(std::vector<Vec3>& polygon, std::vector<Vec3>& clipped, const Depth& depth) {
  clipped.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = i + 1 < polygon.size() ? i + 1 : 0;
    const double here = depth(i), next = depth(j);
    if (here >= 0.0) clipped.push_back(polygon[i]);
    if ((here >= 0.0) != (next >= 0.0))
      clipped.push_back(polygon[i] + here / (here - next) * (polygon[j] - polygon[i]));
  }
  polygon.swap(clipped);
}

void clip_to_planes(const mesh::ConvexSolid& solid, RubbingWork& w) {
  for (std::size_t k = 0; k < solid.planes && !w.polygon.empty(); ++k) {
    const Vec3 n = mesh::normal(solid, k);
    const auto depth = [&](std::size_t i) { return solid.b[k] - n.dot(w.polygon[i]); };
    clip(w.polygon, w.clipped, depth);
  }
}

/// Whether the three points lie beyond one side of the box.
bool is_beside(const mesh::Box& box, const std::vector<Vec3>& x) {
  for (int i = 0; i < 3; ++i) {
    if (x[0][i] < box.lo[i] && x[1][i] < box.lo[i] && x[2][i] < box.lo[i]) return true;
    if (x[0][i] > box.hi[i] && x[1][i] > box.hi[i] && x[2][i] > box.hi[i]) return true;
  }
  return false;
}

/// Sums over flat polygons in the frame P.
struct Sums {
  double area = 0.0;
  Vec3 area_vector = Vec3::Zero(), moment = Vec3::Zero();
};

void add_polygon(const std::vector<Vec3>& polygon, Sums& sums) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec3 vector = mesh::area_vector(polygon[0], polygon[i - 1], polygon[i]);
    const double area = vector.norm();
    sums.area += area;
    sums.area_vector += vector;
    sums.moment += area / 3.0 * (polygon[0] + polygon[i - 1] + polygon[i]);
  }
}

/// Of a triangle, by the places of its vertices in `near`; -1: elsewhere, which is outside the part.
void add_triangle(const Rock& rock, const RubbingPart& part, const Pose& X_PW,
                  const std::array<int, 3>& corners, double edge, RubbingWork& w, Sums& sums) {
  std::array<double, 3> depth{};
  w.polygon.clear();
  for (const int v : corners) {
    const int slot = w.slot[at(v)];
    const std::size_t corner = w.polygon.size();
    w.polygon.push_back(slot >= 0 ? w.near_P[at(slot)] : X_PW * rock.surface.position(v));
    if (part.tree_P) depth[corner] = slot >= 0 ? w.depth[at(slot)] : -edge;
  }
  if (is_beside(part.box_P, w.polygon)) return;
  if (part.tree_P)
    clip(w.polygon, w.clipped, [&](std::size_t i) { return depth[i]; });
  else
    clip_to_planes(part.solid_P, w);
  add_polygon(w.polygon, sums);
}

/// Each triangle once: from its first vertex that is near.
Sums sum_triangles(const Rock& rock, const RubbingPart& part, const Pose& X_PW, double edge,
                   RubbingWork& w) {
  Sums sums;
  const mesh::Surface& s = rock.surface;
  const auto comes_later = [&](int v, int other) { return other > v || w.slot[at(other)] < 0; };
  for (const int v : w.near) {
    const mesh::VertexStar& star = s.star(v);
    const int *ring = s.ring(star), last = star.size - 1;
    for (int i = 0; i < star.size - star.open; ++i) {
      const int a = ring[i], b = ring[i < last ? i + 1 : 0];
      if (comes_later(v, a) && comes_later(v, b))
        add_triangle(rock, part, X_PW, {v, a, b}, edge, w, sums);
    }
  }
  return sums;
}

}  // namespace

RubbingPart prepare_rubbing_part(const bit::Part& part, int index) {
  RubbingPart prepared{index, mesh::bounding_box(part.mesh_P), {}, {}};
  if (auto solid = mesh::convex_solid(part.mesh_P))
    prepared.solid_P = std::move(*solid);
  else
    prepared.tree_P.emplace(part.mesh_P);
  return prepared;
}

ContactPatch rubbing_contact(const Rock& rock, const RubbingPart& part, const Pose& X_WP,
                             double edge, RubbingWork& w) {
  find_near(rock, part, X_WP, edge, w);
  if (part.tree_P) find_depths(part, edge, w);
  const Sums sums = sum_triangles(rock, part, inverse(X_WP), edge, w);
  forget_near(w);
  if (!(sums.area > 0.0)) return {};
  return {sums.area, X_WP.R * sums.area_vector, X_WP * (sums.moment / sums.area)};
}

double depth_in_rock(const mesh::Surface& surface, const bit::Part& part, const Pose& X_WP) {
  const mesh::TriangleTree tree(part.mesh_P);
  const mesh::Box box_P = tree.box();
  const Pose X_PW = inverse(X_WP);
  std::vector<double> depths(surface.stars.size(), 0.0);
  parallel_for(surface.vertex_slots(), [&](int v) {
    if (!surface.is_alive(v)) return;
    const Vec3 x_P = X_PW * surface.position(v);
    if (box_P.contains(x_P) && mesh::inside(tree, x_P)) depths[at(v)] = mesh::distance(tree, x_P);
  });
  return depths.empty() ? 0.0 : std::ranges::max(depths);
}

}  // namespace tdbd::rock
