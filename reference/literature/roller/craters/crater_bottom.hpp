#pragma once

#include "core/types.hpp"
#include "reference/literature/surface/z_map.hpp"

namespace tdbd::reference {

/// Shape of the crater of a tooth: the cone of rock that chips out around its tip (brittle), or the
/// imprint of its round end (ductile).
enum class CraterShape { cone, sphere };

/// A crater of a tooth whose tip was at `tip_W` (z down), `depth` below the bottom.
struct Crater {
  Vec3 tip_W = Vec3::Zero();  ///< m
  double depth = 0.0;         ///< m
  double radius = 0.0;        ///< m: of a cone at the level of the bottom, or of the sphere itself
  CraterShape shape = CraterShape::cone;
};

/// Volume of an isolated crater in flat rock, m3: pi R^2 depth/3 for a cone, a cap for a sphere.
double isolated_volume(const Crater& crater);

/// Depth of the bottom at (x, y), m: linear between the centres of the map's cells, constant beyond
/// the outermost centres. The models of Ma, Zhou and Deng and of Huang and Cawthorne have a bottom
/// that is not described in any text available to us; a height field is our reconstruction.
double level_at(const ZMap& bottom, double x, double y);

/// Removes the rock above the crater's surface. Returns the removed volume, m3: less than the
/// isolated volume where earlier craters were, more in a ridge.
double dig(ZMap& bottom, const Crater& crater);

}  // namespace tdbd::reference
