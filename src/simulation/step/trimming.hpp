#pragma once

#include "rock/maintain/maintain.hpp"
#include "rock/maintain/trim.hpp"
#include "rock/rock.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Progress of trimming the wall above the bit (rock.trim).
struct Trimming {
  double done_W = -1e300;  ///< m: z of the last plane
  long triangles = 0;      ///< removed

  template <class Archive>
  void serialize(Archive& a) {
    a(done_W, triangles);
  }
};

/// Height of the trimming plane above the origin of the bit, m; 0 if the case does not trim. All
/// cutting parts are below it. Throws InputError if rock.trim is smaller than the height of the bit
/// plus some edge lengths of wall.
double trim_height(const Case& c);

/// Trims above the plane at this z (m) if it has moved down by at least an edge length (m) since
/// the last time. Returns the volume of the hole that was removed with the wall, m3.
double trim(double edge_length, double plane_W, const rock::MaintenanceLimits& limits,
            rock::Rock& rock, Trimming& trimming, rock::TrimWorkspace& work);

}  // namespace tdbd::simulation
