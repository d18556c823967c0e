#pragma once

#include <array>
#include <vector>

#include "mesh/measures.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Bounding-volume tree over the facets of a mesh. Boxes are split at the median centroid along
/// their longest side. The run time of a query grows with the logarithm of the number of facets
/// plus the number of facets found. A query allocates nothing, and its order depends on the mesh
/// only. Thesis: the fallback search of 4.1.3.3 and 4.1.3.4, reconstructed.
class TriangleTree {
 public:
  TriangleTree() = default;
  explicit TriangleTree(const TriangleMesh& m);

  /// The box of all facets; empty (lo > hi) if there are none.
  Box box() const { return nodes_.empty() ? Box{} : nodes_.front().box; }
  const std::vector<Facet>& facets() const { return facets_; }

  /// Calls visit(facet) for every facet of every leaf for which meets(box) is true for its box and
  /// all enclosing boxes. Stops if visit returns false, and then returns false.
  template <class Meets, class Visit>
  bool visit(Meets&& meets, Visit&& visit) const {
    std::array<int, 64> waiting;  // enough for 2^63 facets
    std::size_t count = 0;
    if (!nodes_.empty()) waiting[count++] = 0;
    while (count > 0) {
      const int n = waiting[--count];
      const Node& node = nodes_[at(n)];
      if (!meets(node.box)) continue;
      if (node.facets == 0) {
        waiting[count++] = node.next;
        waiting[count++] = n + 1;
      }
      for (int i = node.next; i < node.next + node.facets; ++i)
        if (!visit(facets_[at(i)])) return false;
    }
    return true;
  }

 private:
  /// The first child of an inner node is the next node.
  struct Node {
    Box box;
    int next = 0;    ///< inner: second child; leaf: first facet
    int facets = 0;  ///< leaf: number of facets; inner: 0
  };
  void build(std::vector<int>& order, int first, int last, const TriangleMesh& m);

  std::vector<Node> nodes_;
  std::vector<Facet> facets_;
};

/// Whether x is inside a closed mesh. Counts the crossings of a ray. If a ray passes too close to
/// an edge, the next direction is tried, and after the last one the winding number decides, so that
/// every position gets a result. On the surface the result is arbitrary. Twin: reference::inside.
bool inside(const TriangleTree& closed, const Vec3& x);

/// Whether the distance from x to any facet is less than `distance` (m).
bool is_near(const TriangleTree& tree, const Vec3& x, double distance);

/// Distance from x to the closest facet, m; infinite without facets.
double distance(const TriangleTree& tree, const Vec3& x);

/// The distance if it is less than `most`, otherwise `most`. Faster than distance().
double distance_up_to(const TriangleTree& tree, const Vec3& x, double most);

/// Distance of one surface from another.
struct SurfaceDistance {
  double largest = 0.0;  ///< m: one-sided Hausdorff distance, a lower bound that is at most the
                         ///< spacing too small
  double volume = 0.0;   ///< m3: integral of the distance over the surface
};

/// Computes the distance of `from` to the surface in a tree at points at most `spacing` (m) apart:
/// at every corner, and at the centroids of equal parts of every triangle, which are the
/// integration points. Zero for an empty `from`; `to` must not be empty. Slow, simple twin:
/// reference::one_sided_hausdorff.
SurfaceDistance distance_to(const TriangleMesh& from, const TriangleTree& to, double spacing);

}  // namespace tdbd::mesh
