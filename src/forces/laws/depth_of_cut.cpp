#include "forces/laws/depth_of_cut.hpp"

#include <array>

#include "forces/part/directions.hpp"

namespace tdbd::forces {
namespace {

const std::array<Coefficient<DepthOfCut>, 3> depth_of_cut_coefficients{{
    {"kn", "Pa", &DepthOfCut::kn, {}, Range::non_negative(), "normal force per width and depth"},
    {"kt",
     "Pa",
     &DepthOfCut::kt,
     {},
     Range::non_negative(),
     "tangential force per width and depth"},
    slip_speed_of<DepthOfCut>(),
}};

}  // namespace

std::span<const Coefficient<DepthOfCut>> DepthOfCut::coefficients() {
  return depth_of_cut_coefficients;
}

PartForce law_force(const DepthOfCut& law, const PartCut& cut) {
  const double section = cut.engaged_edge * cut.depth;
  return cutting_force(cut, law.kt * section, law.kn * section, law.slip_speed);
}

}  // namespace tdbd::forces
