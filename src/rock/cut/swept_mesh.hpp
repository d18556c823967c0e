#pragma once

#include <optional>
#include <vector>

#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {

/// An interval of t (levels of a strip).
struct Levels {
  double lo, hi;
};

/// The surface x(tau, t) = q(tau) + t u(tau), tau in [0, 1], 0 <= t <= t_max, that a vertex and its
/// update direction sweep in a part's frame, rock (3). At a fixed t it is a straight segment,
/// called a level.
class Strip {
 public:
  /// t_max is chosen so that the strip reaches beyond `box`, the part's box. u must not vanish
  /// between u0 and u1.
  Strip(const RelativePath& path, const mesh::Box& box);

  Vec3 at(double tau, double t) const { return q_ + tau * dq_ + t * (u_ + tau * du_); }

  /// The same strip up to t.
  Strip up_to(double t) const;

  /// Whether the strip may meet the box. Conservative: never false if it does.
  bool meets(const mesh::Box& box) const;

  /// Adds the intervals of t whose levels meet the facet. They end where the strip's sides tau = 0
  /// and tau = 1 meet the facet and where the facet's edges meet the strip. Between these ends t is
  /// a monotonic function of tau on the facet (a Moebius map). Ends closer than `same` (m) are
  /// merged. `ends`: buffer.
  void levels_that_meet(const mesh::Facet& f, double same, std::vector<double>& ends,
                        std::vector<Levels>& intervals) const;

 private:
  void add_side(const mesh::Facet& f, double tau, std::vector<double>& ends) const;
  void add_edge(const Vec3& a, const Vec3& b, std::vector<double>& ends) const;
  bool level_meets(const mesh::Facet& f, double t) const;

  Vec3 q_, dq_, u_, du_;
  double t_max_;
  Vec3 middle_, inverse_;  ///< the ray tau = 1/2: origin, 1 / direction
  Vec3 half_width_;        ///< of the strip about that ray, along the coordinate axes
};

/// Buffers of a query, kept between queries to avoid allocations.
struct MeshScratch {
  std::vector<double> ends;
  std::vector<Levels> intervals;
};

/// Whether the path of the vertex alone enters the solid inside a closed mesh by more than `depth`
/// (m). Between two crossings of the surface the path is wholly inside or wholly outside.
bool is_swept(const mesh::TriangleTree& solid, const RelativePath& path, double depth,
              MeshScratch& scratch);

/// Returns the exit distance, m, of a swept vertex from the solid inside any closed mesh: the end
/// of the connected set of t, from t = 0 on, for which some tau puts q(tau) + t u(tau) inside.
/// Returns nothing if the vertex is not swept. Exact for linear q and u: the levels at which the
/// strip begins and ceases to meet facets bound that set (Strip), and what lies between two such
/// intervals is wholly inside or outside. Gaps up to `depth` (m) do not separate. Same meaning as
/// for a convex solid (swept_part.hpp). See rock (3); thesis: 4.1.3.3 (reconstructed). Twin:
/// reference/rock/brute_force_exit.
std::optional<double> exit_distance(const mesh::TriangleTree& solid, const RelativePath& path,
                                    double depth, MeshScratch& scratch);

}  // namespace tdbd::rock
