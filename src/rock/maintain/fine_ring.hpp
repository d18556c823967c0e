#pragma once

#include "core/single.hpp"
#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// Limits beyond which no operation wants a triangle, drawn in by more than single precision rounds.
struct FineLimits {
  Single short2 = 0,
         long2 = 0;  ///< m2, of squared edges; short2 of doubled areas seen from above too
  Single quality2 = 0;
};

FineLimits fine_limits(const MaintenanceLimits& limits);

/// Whether no operation wants a triangle at v, nor is one steep or folded on a neighbour: eight
/// triangles at once. Conservative: no may be wrong, yes is not. Folds across an edge that faces v
/// are asked only where neither of its ends is touched; otherwise they are its ends' to find.
bool ring_is_fine(const Rock& rock, int v, const FineLimits& limits);

}  // namespace tdbd::rock
