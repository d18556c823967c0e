#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Upper bound, per vertex, m, of the distance by which the operations of one maintenance have
/// moved the surface. No point of a triangle is farther from the surface before the maintenance
/// than the largest value of its vertices (M6, rock (18)). An operation adds its own distance to
/// the largest value around it.
class SurfaceDrift {
 public:
  double of(int v) const { return at(v) < by_vertex_.size() ? by_vertex_[at(v)] : 0.0; }

  /// Raises the value of v to at least `distance`.
  void note(int v, double distance);

  void clear();

 private:
  std::vector<double> by_vertex_;
  std::vector<int> listed_;
};

/// The largest drift at v and its neighbours, m.
double largest_drift_around(const mesh::Surface& s, int v, const SurfaceDrift& drift);

/// Result of the guards on an operation. Computing it changes nothing.
struct Verdict {
  std::optional<Refusal> refused;  ///< the first reason; empty: accepted
  double volume = 0.0;             ///< m3 of hole gained
  double drift = 0.0;  ///< m, from the surface before the maintenance, after the operation
};

/// Moves v to x_W if the verdict accepts it, and counts the operation or its refusal. Returns
/// whether v was moved. Debug builds check the surface's promises around v.
bool move_if_accepted(Rock& rock, int v, const Vec3& x_W, Operation what, const Verdict& verdict,
                      SurfaceDrift& drift, MaintenanceReport& report);

}  // namespace tdbd::rock
