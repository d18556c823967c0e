#pragma once

#include "reference/literature/surface/planar_region.hpp"

namespace tdbd::reference {

/// The borders of a spoke's plane: the axis r = 0, the end of the spoke, the bottom of the rock.
struct SpokeFrame {
  double radius = 0.0, floor = 0.0;  ///< m
};

/// The longest edge of the surface over the requested spacing.
inline constexpr double widest_spacing = 1.5;

/// Respaces the nodes of the surface about equally; the frame's own edges keep only their corners.
/// First nodes are removed, always the one that changes the area least, wherever two edges that
/// meet are together no longer than the longest edge; then longer edges are divided evenly. So two
/// edges that meet are together longer than half the longest edge, and a surface of length L has at
/// most 3 L / (widest_spacing spacing) nodes, plus one at each end. Cavities that shrink below a
/// triangle vanish. Reconstructed: our excerpt says that the number of nodes varies, not how.
PlanarFace respaced(const PlanarFace& face, const SpokeFrame& frame, double spacing);

}  // namespace tdbd::reference
