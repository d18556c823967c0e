#pragma once

#include "reference/literature/surface/planar_region.hpp"

namespace tdbd::reference {

/// The borders of a spoke's plane: the axis r = 0, the end of the spoke, and the bottom of the
/// rock.
struct SpokeFrame {
  double radius = 0.0, floor = 0.0;  ///< m
};

/// Longest edge of the surface, in units of the requested spacing.
inline constexpr double widest_spacing = 1.5;

/// Makes the node spacing of the surface approximately uniform; the frame's own edges keep only
/// their corners. First, nodes are removed wherever two adjacent edges together are no longer than
/// the longest edge, always the node that changes the area least. Then longer edges are divided
/// evenly. So two adjacent edges together are longer than half the longest edge, and a surface of
/// length L has at most 3 L / (widest_spacing spacing) nodes, plus one at each end. Cavities that
/// shrink below a triangle vanish. Reconstructed: our excerpt states that the number of nodes
/// varies, but not how.
PlanarFace respaced(const PlanarFace& face, const SpokeFrame& frame, double spacing);

}  // namespace tdbd::reference
