#pragma once

#include <algorithm>

#include "rock/cut/cutting_bit.hpp"
#include "rock/cut/swept_part.hpp"
#include "rock/rock.hpp"

namespace tdbd::simulation {

/// How deep the deepest rock vertex lies inside a cutting part at a pose, m.
inline double deepest_penetration(const rock::Rock& rock, const rock::CuttingBit& bit,
                                  const Pose& X_WB) {
  double deepest = 0.0;
  for (const rock::CuttingGroup& g : bit.groups) {
    if (g.presence == rock::GroupActivity::away) continue;
    const Pose X_PW = inverse(X_WB * g.X_BP);
    for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
      const Vec3 x_P = X_PW * rock.surface.position(v);
      if (!rock.surface.is_alive(v) || !g.box_P.contains(x_P)) continue;
      for (const rock::CuttingPart& part : g.parts)
        deepest = std::max(deepest, rock::depth_inside(part, x_P));
    }
  }
  return deepest;
}

}  // namespace tdbd::simulation
