#include "simulation/step/trimming.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bit/cone/swept_parts.hpp"
#include "core/error.hpp"

namespace tdbd::simulation {

double trim_height(const Case& c) {
  if (c.rock.trim <= 0.0) return 0.0;
  double lowest = -1e300, highest = 1e300;  // z down
  for (const bit::Part& p : bit::swept_parts(c.bit))
    for (const Vec3& x_P : p.mesh_P.positions) {
      const double z_B = (p.X_BP * x_P).z();
      lowest = std::max(lowest, z_B);
      highest = std::min(highest, z_B);
    }
  constexpr double edges_of_wall = 4.0;
  const double least = lowest - highest + edges_of_wall * c.rock.edge_length;
  if (c.rock.trim < least)
    throw InputError(fmt::format(
        "{}: rock.trim: found {:.4g} mm, expected at least {:.4g} mm: the height of the cutting "
        "parts and some edge lengths of wall",
        c.path, 1e3 * c.rock.trim, 1e3 * least));
  return c.rock.trim - lowest;
}

double trim(double edge_length, double plane_W, const rock::MaintenanceLimits& limits,
            rock::Rock& rock, Trimming& trimming, rock::TrimWorkspace& work) {
  if (plane_W < trimming.done_W + edge_length) return 0.0;
  rock::TrimReport report;
  rock::trim_wall(rock, trimming.done_W - 2.0 * limits.longest_edge, plane_W, work, report);
  trimming.triangles += report.triangles;
  trimming.done_W = plane_W;
  return report.volume;
}

}  // namespace tdbd::simulation
