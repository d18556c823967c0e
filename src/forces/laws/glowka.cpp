#include "forces/laws/glowka.hpp"

#include <array>
#include <cmath>

#include "forces/laws/virgin_groove.hpp"
#include "forces/part/directions.hpp"

namespace tdbd::forces {
namespace {

const std::array<Coefficient<Glowka>, 5> glowka_coefficients{{
    {"Cn", "N", &Glowka::Cn, {}, Range::non_negative(), "normal force at 1 mm of depth"},
    {"nn",
     "1",
     &Glowka::nn,
     {},
     Range{.lo = 0.0, .hi = 4.0, .ends = Range::Ends::open_lo},
     "power of the normal force in the depth"},
    {"Cd", "N", &Glowka::Cd, {}, Range::non_negative(), "drag at 1 mm of depth"},
    {"nd",
     "1",
     &Glowka::nd,
     {},
     Range{.lo = 0.0, .hi = 4.0, .ends = Range::Ends::open_lo},
     "power of the drag in the depth"},
    slip_speed_of<Glowka>(),
}};

}  // namespace

std::span<const Coefficient<Glowka>> Glowka::coefficients() { return glowka_coefficients; }

PartForce law_force(const Glowka& law, const PartCut& cut) {
  if (cut.diameter <= 0.0 || cut.cut_area <= 0.0) return cutting_force(cut, 0.0, 0.0, 0.0);
  const GrooveDepth groove = groove_depth({cut.diameter, cut.back_rake}, cut.cut_area);
  const double relative = groove.depth / Glowka::reference_depth;
  return cutting_force(cut, law.Cd * std::pow(relative, law.nd),
                       law.Cn * std::pow(relative, law.nn), law.slip_speed);
}

}  // namespace tdbd::forces
