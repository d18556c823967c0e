#include "forces/laws/depth_of_cut.hpp"

#include <array>

#include "forces/part/directions.hpp"

namespace tdbd::forces {
namespace {

const std::array<Coefficient<DepthOfCut>, 3> table{{
    {"kn", "Pa", &DepthOfCut::kn, {}, Range::non_negative(), "normal force a width and depth"},
    {"kt", "Pa", &DepthOfCut::kt, {}, Range::non_negative(), "tangential force a width and depth"},
    {"slip_speed", "m/s", &DepthOfCut::slip_speed, usual_slip_speed, Range::non_negative(),
     "speed below which the force fades"},
}};

}  // namespace

std::span<const Coefficient<DepthOfCut>> DepthOfCut::coefficients() { return table; }

PartForce law_force(const DepthOfCut& law, const PartCut& cut) {
  const double section = cut.engaged_edge * cut.depth;
  return cutting_force(cut, law.kt * section, law.kn * section, law.slip_speed);
}

}  // namespace tdbd::forces
