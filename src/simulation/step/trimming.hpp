#pragma once

#include "rock/maintain/maintain.hpp"
#include "rock/maintain/trim.hpp"
#include "rock/rock.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// How far the wall above the bit has been trimmed (rock.trim).
struct Trimming {
  double done_W = -1e300;  ///< m: the last plane's z
  long triangles = 0;      ///< removed
};

/// Height of the trimming plane above the bit's origin, m; 0: the case does not trim. All that cuts
/// stays below it. InputError: rock.trim is less than the bit and some edges of wall need.
double trim_height(const Case& c);

/// Trims above the plane at this z (m) once it has gone down by an edge length (m) since it last
/// did. Returns the volume of the hole that went with the wall, m3.
double trim(double edge_length, double plane_W, const rock::MaintenanceLimits& limits,
            rock::Rock& rock, Trimming& trimming, rock::TrimWorkspace& work);

}  // namespace tdbd::simulation
