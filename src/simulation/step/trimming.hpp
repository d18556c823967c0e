#pragma once

#include "rock/maintain/maintain.hpp"
#include "rock/maintain/trim.hpp"
#include "rock/rock.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Where the wall ends above the bit, when it is trimmed (rock.trim).
struct Trimming {
  double height = 0.0;     ///< m, of the plane above the bit's origin; 0: no trimming
  double done_W = -1e300;  ///< m: the last plane's z
  long triangles = 0;      ///< removed
  rock::TrimWorkspace work;
};

/// Height of the trimming plane above the bit's origin; 0: the case does not trim. All that cuts
/// stays below it. InputError: rock.trim is less than the bit and some edges of wall need.
double trim_height(const Case& c);

/// Trims when the bit's origin is at this depth (m), once the plane has gone down by an edge since
/// it last did. Returns the volume of the hole that went with the wall, m3.
double trim(const Case& c, double bit_z_W, const rock::MaintenanceLimits& limits, rock::Rock& rock,
            Trimming& trimming);

}  // namespace tdbd::simulation
