#include "rock/section/rubbing_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "core/sort_unique.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "rock/cut/sieves.hpp"

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

/// Whether the part cannot have reached any rock: its axis and its place have moved by no more than
/// the margin since it was clear, and only the cut has changed the rock.
bool stays_clear(const Rock& rock, const Pose& X_WP, const CutWorkspace& cut, RubbingPart& part) {
  RubbingPart::Clear& c = part.clear;
  if (c.changes < 0 || c.changes != cut.changes_before) return false;
  const double moved =
      (X_WP.p - c.X_WP.p).norm() + (X_WP.R.col(2) - c.X_WP.R.col(2)).norm() * part.reach;
  if (moved > part.underside_P.margin) return false;
  const Pose X_PW = inverse(c.X_WP);
  for (const GroupCut& g : cut.groups)
    for (const int v : g.moved_in_step)
      if (may_contain(part.underside_P, Around::vertex, X_PW * rock.surface.position(v), 0.0))
        return false;
  c.changes = rock.grid.changes();
  return true;
}

/// The vertices of a block in the frame of a part, m, and their squared distances from its axis,
/// m2. The eighth entry is meaningless.
struct BlockPlaces {
  std::array<Single, single_lanes> x, y, z, r2;
};

TDBD_WIDE void put_in_part(const VertexGrid::Block& block, const SingleFrame& X_PW,
                           BlockPlaces& out) {
  WidePoints x_W, q;
  load(block, x_W);
  put_in_frame(x_W, X_PW, q);
  const WideSingle r2 = q.x * q.x + q.y * q.y;
  TDBD_STORE(q.x, out.x.data());
  TDBD_STORE(q.y, out.y.data());
  TDBD_STORE(q.z, out.z.data());
  TDBD_STORE(r2, out.r2.data());
}

/// Collects the vertices that are not certainly outside the part, and determines whether the part
/// is clear of all. As soon as it is not clear, only the columns are tested.
void collect_uncertain(const Rock& rock, const Pose& X_WP, RubbingPart& part, RubbingWork& w) {
  const Pose X_PW = inverse(X_WP);
  const Underside& u = part.underside_P;
  const double height =
      0.5 * rock.grid.cell() * X_PW.R.row(2).lpNorm<1>();  // of half a cell along z
  const auto may = [&](const Vec3& middle_P, VertexGrid::Span span) {
    return span == VertexGrid::Span::tile ? may_contain(u, Around::tile, middle_P, 4.0 * height)
                                          : may_contain(u, Around::cell, middle_P, height);
  };
  const mesh::Box box_W = widened(region_of(part.box_P, X_WP), u.margin).box;
  part.clear = {rock.grid.changes(), X_WP};
  bool is_clear = true;
  const SingleFrame single_PW = single_frame(X_PW, Vec3::Zero());
  BlockPlaces places_P;
  rock.grid.visit_where(box_W, X_PW, may, [&](const VertexGrid::Block& block) {
    put_in_part(block, single_PW, places_P);
    for (std::size_t s = 0; s < at(block.count); ++s) {
      if (is_clear && !may_contain(u, places_P.r2[s], places_P.z[s])) continue;
      is_clear = false;
      if (may_contain(u, Vec3(places_P.x[s], places_P.y[s], places_P.z[s])))
        w.near.push_back(block.v[s]);
    }
  });
  if (!is_clear) part.clear.changes = -1;
}

/// Keeps the vertices inside the part and adds their neighbours; other triangles do not count.
void keep_inside(const Rock& rock, const RubbingPart& part, const Pose& X_WP, RubbingWork& w) {
  const Pose X_PW = inverse(X_WP);
  w.depth.assign(w.near.size(), 0.0);
  parallel_for(static_cast<int>(w.near.size()), [&](int i) {
    const Vec3 x_P = X_PW * rock.surface.position(w.near[at(i)]);
    if (part.box_P.contains(x_P) && mesh::inside(*part.tree_P, x_P)) w.depth[at(i)] = 1.0;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < w.near.size(); ++i)
    if (w.depth[i] > 0.0) w.near[kept++] = w.near[i];
  w.near.resize(kept);
  for (std::size_t i = 0; i < kept; ++i) {
    const mesh::VertexStar& star = rock.surface.star(w.near[i]);
    const int* ring = rock.surface.ring(star);
    w.near.insert(w.near.end(), ring, ring + star.size);
  }
}

void find_near(const Rock& rock, const Pose& X_WP, double edge, RubbingPart& part, RubbingWork& w) {
  const Pose X_PW = inverse(X_WP);
  w.near.clear();
  if (part.tree_P) {
    collect_uncertain(rock, X_WP, part, w);
    keep_inside(rock, part, X_WP, w);
  } else {
    const Region region_W = widened(region_of(part.box_P, X_WP), edge);
    find_around_box(rock, region_W, part.box_P, X_PW, w.around, w.near);
  }
  sort_unique(w.near);
  w.near_P.clear();
  w.beyond.clear();
  w.slot.resize(rock.surface.stars.size(), -1);
  for (std::size_t i = 0; i < w.near.size(); ++i) {
    w.slot[at(w.near[i])] = static_cast<int>(i);
    w.near_P.push_back(X_PW * rock.surface.position(w.near[i]));
    w.beyond.push_back(sides_beyond(part.box_P, w.near_P.back()));
  }
}

void forget_near(RubbingWork& w) {
  for (const int v : w.near) w.slot[at(v)] = -1;
}

/// Signed distances of the near vertices from a part that is not convex. Far outside, only the sign
/// is correct.
void find_depths(const RubbingPart& part, double edge, RubbingWork& w) {
  w.depth.assign(w.near.size(), -edge);
  parallel_for(static_cast<int>(w.near.size()), [&](int i) {
    const Vec3& x_P = w.near_P[at(i)];
    const double distance = mesh::distance_up_to(*part.tree_P, x_P, edge);
    const bool is_inside = part.box_P.contains(x_P) && mesh::inside(*part.tree_P, x_P);
    w.depth[at(i)] = is_inside ? distance : -distance;
  });
}

/// Clips a polygon to where `depth`, linear along its edges, is not negative.
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

/// Sums over flat polygons in the frame P.
struct Sums {
  double area = 0.0;
  Vec3 area_vector = Vec3::Zero(), moment = Vec3::Zero();
};

/// Sectors about the z axis of P; a convex part uses only the first.
constexpr std::size_t sectors = 16;
using SumsBySector = std::array<Sums, sectors>;

std::size_t sector_of(const Vec3& x_P) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double share = std::atan2(x_P.y(), x_P.x()) / turn + 0.5;
  return std::min(sectors - 1, static_cast<std::size_t>(share * sectors));
}

ContactPatch patch_of(const Sums& sums, const Pose& X_WP) {
  return {sums.area, X_WP.R * sums.area_vector, X_WP * (sums.moment / sums.area)};
}

void add_polygon(const std::vector<Vec3>& polygon, Sums& sums) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec3 vector = mesh::area_vector(polygon[0], polygon[i - 1], polygon[i]);
    const double area = vector.norm();
    sums.area += area;
    sums.area_vector += vector;
    sums.moment += area / 3.0 * (polygon[0] + polygon[i - 1] + polygon[i]);
  }
}

/// Adds a triangle, using the slots of its vertices in `near`. A vertex with slot -1 is outside the
/// part.
void add_triangle(const Rock& rock, const RubbingPart& part, const Pose& X_PW,
                  const std::array<int, 3>& corners, double edge, RubbingWork& w,
                  SumsBySector& sums) {
  std::array<double, 3> depth{};
  unsigned beyond_all = ~0U;
  w.polygon.clear();
  for (const int v : corners) {
    const int slot = w.slot[at(v)];
    const std::size_t corner = w.polygon.size();
    w.polygon.push_back(slot >= 0 ? w.near_P[at(slot)] : X_PW * rock.surface.position(v));
    beyond_all &= slot >= 0 ? w.beyond[at(slot)] : sides_beyond(part.box_P, w.polygon.back());
    if (part.tree_P) depth[corner] = slot >= 0 ? w.depth[at(slot)] : -edge;
  }
  if (beyond_all != 0) return;
  if (part.tree_P)
    clip(w.polygon, w.clipped, [&](std::size_t i) { return depth[i]; });
  else
    clip_to_planes(part.solid_P, w);
  if (w.polygon.empty()) return;
  add_polygon(w.polygon, sums[part.tree_P ? sector_of(w.polygon.front()) : 0]);
}

/// Whether three vertices are near and all lie beyond the same side of the part's box.
bool are_beyond(const RubbingWork& w, int a, int b, int c) {
  const int i = w.slot[at(a)], j = w.slot[at(b)], k = w.slot[at(c)];
  return i >= 0 && j >= 0 && k >= 0 && (w.beyond[at(i)] & w.beyond[at(j)] & w.beyond[at(k)]) != 0;
}

/// Adds each triangle once: at its first near vertex.
SumsBySector sum_triangles(const Rock& rock, const RubbingPart& part, const Pose& X_PW, double edge,
                           RubbingWork& w) {
  SumsBySector sums;
  const mesh::Surface& s = rock.surface;
  const auto comes_later = [&](int v, int other) { return other > v || w.slot[at(other)] < 0; };
  for (const int v : w.near) {
    const mesh::VertexStar& star = s.star(v);
    const int *ring = s.ring(star), last = star.size - 1;
    for (int i = 0; i < star.size - star.open; ++i) {
      const int a = ring[i], b = ring[i < last ? i + 1 : 0];
      if (comes_later(v, a) && comes_later(v, b) && !are_beyond(w, v, a, b))
        add_triangle(rock, part, X_PW, {v, a, b}, edge, w, sums);
    }
  }
  return sums;
}

}  // namespace

RubbingPart prepare_rubbing_part(const bit::Part& part, int index, double cell) {
  RubbingPart prepared;
  prepared.part = index;
  prepared.box_P = mesh::bounding_box(part.mesh_P);
  for (const Vec3& x_P : part.mesh_P.positions)
    prepared.reach = std::max(prepared.reach, x_P.norm());
  if (auto solid = mesh::convex_solid(part.mesh_P)) {
    prepared.solid_P = std::move(*solid);
    return prepared;
  }
  prepared.tree_P.emplace(part.mesh_P);
  prepared.underside_P = underside_of(part.mesh_P, cell);
  return prepared;
}

ContactPatch rubbing_contact(const Rock& rock, RubbingPart& part, const Pose& X_WP, double edge,
                             const CutWorkspace& cut, RubbingWork& w) {
  w.patches.clear();
  if (part.tree_P && stays_clear(rock, X_WP, cut, part)) return {};
  find_near(rock, X_WP, edge, part, w);
  if (part.tree_P) find_depths(part, edge, w);
  Sums whole;
  for (const Sums& sums : sum_triangles(rock, part, inverse(X_WP), edge, w)) {
    if (!(sums.area > 0.0)) continue;
    w.patches.push_back(patch_of(sums, X_WP));
    whole.area += sums.area;
    whole.area_vector += sums.area_vector;
    whole.moment += sums.moment;
  }
  forget_near(w);
  return w.patches.empty() ? ContactPatch{} : patch_of(whole, X_WP);
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
