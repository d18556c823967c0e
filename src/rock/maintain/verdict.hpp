#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// How far at most the operations of one maintenance have moved the surface, per vertex, m: no
/// point of a triangle is farther from the surface before the maintenance than the largest figure
/// of its vertices (M6, rock (18)). An operation takes the largest figure around it and adds its
/// own distance.
class SurfaceDrift {
 public:
  double of(int v) const { return at(v) < by_vertex_.size() ? by_vertex_[at(v)] : 0.0; }

  /// Raises the figure of v to `distance`.
  void note(int v, double distance);

  void clear();

 private:
  std::vector<double> by_vertex_;
  std::vector<int> listed_;
};

/// The largest drift at v and its neighbours, m.
double largest_drift_around(const mesh::Surface& s, int v, const SurfaceDrift& drift);

/// What the guards say about an operation; asking changes nothing.
struct Verdict {
  std::optional<Refusal> refused;  ///< the first reason; nothing: accepted
  double volume = 0.0;             ///< m3 of hole gained
  double drift = 0.0;  ///< m: how far the surface then is from that before the maintenance
};

/// Moves v to x_W if the verdict accepts it, and counts the operation or its refusal. Returns
/// whether it was carried out. Debug builds check the surface's promises around it.
bool move_if_accepted(Rock& rock, int v, const Vec3& x_W, Operation what, const Verdict& verdict,
                      SurfaceDrift& drift, MaintenanceReport& report);

}  // namespace tdbd::rock
