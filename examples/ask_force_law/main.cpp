// Evaluates a force law: the force of the rock on the face of a round cutter at several depths of
// cut.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "forces/law.hpp"

using namespace tdbd;
using namespace tdbd::forces;

/// A sharp 19 mm cutter, raked back by 20 degrees, that scrapes along x at 1 m/s; the rock lies below, along z.
PartCut groove(double depth) {
  constexpr double radius = 9.5e-3;  // m
  const double half_angle =
      std::acos(1.0 - depth / radius);  // rad, of the edge that is in the rock
  PartCut cut;
  cut.kind = bit::PartKind::face;
  cut.depth = depth;
  cut.engaged_edge = 2.0 * radius * half_angle;
  cut.cut_area = radius * radius * (half_angle - std::sin(half_angle) * std::cos(half_angle));
  cut.back_rake = 20.0 * std::numbers::pi / 180.0;
  cut.diameter = 2.0 * radius;
  cut.velocity = Vec3(1.0, 0.0, 0.0);
  cut.normal = Vec3(0.0, 0.0, 1.0);
  cut.strength = {.unconfined = 60e6, .confined = 90e6, .friction_angle = 0.6, .pressure = 20e6};
  return cut;
}

int main() {
  Detournay law;
  law.eps = 90e6;  // Pa, energy to cut a volume
  law.zeta = 0.6;  // normal over tangential force
  if (const auto problem = law_problem(law, bit::PartKind::face, 19e-3); !problem.empty()) {
    std::fprintf(stderr, "ask_force_law: %s\n", problem.c_str());
    return 1;
  }
  std::puts("depth mm   area mm2   drag N   normal N");
  for (const double depth : {0.25e-3, 0.5e-3, 1e-3, 2e-3}) {
    const PartCut cut = groove(depth);
    const PartForce f = force(law, cut);
    std::printf("%8.2f %10.3f %8.1f %10.1f\n", 1e3 * depth, 1e6 * cut.cut_area, f.tangential,
                f.normal);
    if (f.force.x() >= 0.0 || f.force.z() >= 0.0)
      return 1;  // the rock brakes the cutter and pushes it away
  }
  return 0;
}
