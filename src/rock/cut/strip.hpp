#pragma once

#include <vector>

#include "mesh/facet.hpp"
#include "mesh/measures.hpp"
#include "rock/cut/relative_path.hpp"

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

}  // namespace tdbd::rock
