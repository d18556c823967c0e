#pragma once

#include "core/types.hpp"
#include "reference/literature/surface/z_map.hpp"

namespace tdbd::reference {

/// What a tooth leaves: the cone of rock that chips out around its point (brittle), or the place of its
/// round end (ductile).
enum class CraterShape { cone, sphere };

/// A crater of a tooth whose point stood at `tip_W` (z down), `depth` below the bottom.
struct Crater {
  Vec3 tip_W = Vec3::Zero();  ///< m
  double depth = 0.0;         ///< m
  double radius = 0.0;        ///< m: of a cone at the bottom's level, of the sphere itself
  CraterShape shape = CraterShape::cone;
};

/// Volume of a crater in flat rock with nothing beside it, m3: pi R^2 depth/3 of a cone, a cap of a sphere.
double isolated_volume(const Crater& crater);

/// How deep the bottom is at (x, y), m: linear between the centres of the map's cells, the outermost
/// beyond them. The models of Ma, Zhou and Deng and of Huang and Cawthorne keep a bottom that nothing we
/// could read describes; a height field is our reconstruction.
double level_at(const ZMap& bottom, double x, double y);

/// Takes away what lies above the crater's surface. Returns the volume removed, m3: less than the isolated
/// one where earlier craters were, more where it is in a ridge.
double dig(ZMap& bottom, const Crater& crater);

}  // namespace tdbd::reference
