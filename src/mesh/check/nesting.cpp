#include "mesh/check/nesting.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mesh/check/self_intersections.hpp"
#include "mesh/check/weld.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"

namespace tdbd::mesh {
namespace {

/// What the tests of two pieces need. Trees are built when they are first used.
struct ClosedPiece {
  Box box;
  double volume = 0.0;  ///< m3, signed
  bool is_closed = false;
  std::optional<TriangleTree> tree;
};

Box box_of(const Facet& f) {
  Box box;
  for (const Vec3& x : {f.a, f.b, f.c}) box.add(x);
  return box;
}

/// Whether two facets intersect; corners at the same position are common.
bool facets_intersect(const Facet& f, const Facet& g) {
  const NamedFacet first{{0, 1, 2}, {f.a, f.b, f.c}};
  NamedFacet second{{3, 4, 5}, {g.a, g.b, g.c}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (second.x[i] == first.x[k]) second.names[i] = first.names[k];
  return intersect(first, second);
}

bool intersects(const TriangleMesh& piece, const TriangleTree& tree) {
  for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
    const auto [a, b, c] = corners(piece, i);
    const Facet facet{a, b, c};
    const Box box = box_of(facet);
    const auto meets = [&](const Box& other) { return other.overlaps(box); };
    const auto is_apart = [&](const Facet& g) {
      return !box_of(g).overlaps(box) || !facets_intersect(facet, g);
    };
    if (!tree.visit(meets, is_apart)) return true;
  }
  return false;
}

bool surrounds(const TriangleMesh& outer, ClosedPiece& o, const TriangleMesh& inner) {
  if (!o.tree) o.tree.emplace(outer);
  const auto [a, b, c] = corners(inner, 0);
  return inside(*o.tree, (a + b + c) / 3.0) && !intersects(inner, *o.tree);
}

Bounds bounds_of(const std::vector<NestedPiece>& all, const NestedPiece& piece) {
  int outside = 0;
  for (const int j : piece.around) outside += all[at(j)].outward ? 1 : -1;
  const int inside = outside + (piece.outward ? 1 : -1);
  return (outside > 0) == (inside > 0) ? Bounds::nothing : Bounds::solid_or_cavity;
}

}  // namespace

std::vector<NestedPiece> nested_pieces(std::vector<TriangleMesh> pieces) {
  std::vector<NestedPiece> all;
  std::vector<ClosedPiece> closed;
  for (TriangleMesh& piece : pieces) {
    TriangleMesh equal{{}, merge_equal_vertices(piece)};
    const double volume = enclosed_volume(piece);
    closed.push_back({bounding_box(piece), volume, open_edges(equal) == 0, {}});
    all.push_back({std::move(piece), {}, static_cast<int>(all.size()), volume > 0.0, {}});
    all.back().bounds = Bounds::unknown;
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j) {
      const Box &box = closed[i].box, &other = closed[j].box;
      if (i == j || !closed[i].is_closed || !closed[j].is_closed || !other.contains(box.lo) ||
          !other.contains(box.hi) || !surrounds(all[j].mesh, closed[j], all[i].mesh))
        continue;
      all[i].around.push_back(static_cast<int>(j));
    }
  const auto size = [&](int i) { return std::abs(closed[at(i)].volume); };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].around.empty())
      all[i].outermost = *std::ranges::max_element(all[i].around, {}, size);
    if (closed[i].is_closed) all[i].bounds = bounds_of(all, all[i]);
  }
  return all;
}

namespace {

/// The group of all facets of a piece, or -1 if they have none or several.
int group_of(const std::vector<int>& group_of_facet, const std::vector<int>& piece) {
  if (group_of_facet.empty()) return -1;
  const int group = group_of_facet[at(piece.front())];
  const bool is_one =
      std::ranges::all_of(piece, [&](int i) { return group_of_facet[at(i)] == group; });
  return is_one ? group : -1;
}

/// Whether the box of any piece contains that of another. Most files have no such pieces. A closed
/// piece has at least four facets.
bool any_may_nest(const TriangleMesh& m, const std::vector<std::vector<int>>& pieces) {
  std::vector<Box> boxes;
  for (const std::vector<int>& piece : pieces) {
    if (pieces.size() == 1 || piece.size() < 4) continue;
    boxes.emplace_back();
    for (const int t : piece)
      for (const Vec3& x : corners(m, at(t))) boxes.back().add(x);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < boxes.size(); ++j)
      if (i != j && boxes[j].contains(boxes[i].lo) && boxes[j].contains(boxes[i].hi)) return true;
  return false;
}

}  // namespace

std::vector<std::vector<int>> facets_of_bodies(const TriangleMesh& m) {
  return facets_of_bodies(m, {});
}

std::vector<std::vector<int>> facets_of_bodies(const TriangleMesh& m,
                                               const std::vector<int>& group_of_facet) {
  std::vector<std::vector<int>> pieces = divided_facets(m), facets(pieces.size());
  if (any_may_nest(m, pieces)) {
    const std::vector<NestedPiece> nested = nested_pieces(submeshes(m, pieces));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const int own = group_of(group_of_facet, pieces[i]);
      const int outer = group_of(group_of_facet, pieces[at(nested[i].outermost)]);
      const bool is_other = own >= 0 && outer >= 0 && own != outer;
      std::vector<int>& body = facets[is_other ? i : at(nested[i].outermost)];
      body.insert(body.end(), pieces[i].begin(), pieces[i].end());
    }
    std::erase_if(facets, [](const std::vector<int>& body) { return body.empty(); });
  } else {
    facets = std::move(pieces);
  }
  for (std::vector<int>& body : facets) std::ranges::sort(body);
  return facets;
}

}  // namespace tdbd::mesh
