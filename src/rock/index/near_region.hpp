#pragma once

#include "core/pose.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// How far lists extend beyond the region that the steps need, for later queries. m.
struct NearListMargins {
  double margin = 0.0;  ///< all around the group
  double ahead = 0.0;   ///< along the group's path
};

/// The motion of a group in a step: its box, its poses at the start and end, and the required
/// region.
struct GroupStep {
  const mesh::Box& box_P;
  const Pose &X_WP0, &X_WP1;
  const Region& region_W;
};

/// How far the middle of the group's box moves in the step, m.
double way_of(const GroupStep& step);

/// Whether the slabs of `region_W` contain everything between the slabs of `part_W`, which are
/// orthogonal.
bool holds(const Region& region_W, const Region& part_W);

/// The region of the group for the next `steps` steps and `margins.ahead` beyond, if its motion
/// continues as in this step. Limited to a rotation of three quarters of a radian.
Region region_ahead(const GroupStep& step, const NearListMargins& margins, int steps);

}  // namespace tdbd::rock
