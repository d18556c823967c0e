#include "forces/laws/friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tdbd::forces {
namespace {

const std::array<Coefficient<Friction>, 7> friction_coefficients{{
    {"stress", "Pa", &Friction::stress, {}, Range::non_negative(), "contact stress"},
    {"mu", "1", &Friction::mu, {}, Range::non_negative(), "coefficient of friction"},
    {"cap", "1", &Friction::cap, 1.5, Range::non_negative(),
     "largest contact stress over the confined strength"},
    {"full_angle", "rad", &Friction::full_angle, 0.01, Range::within(0.0, 1.0),
     "angle of motion into the rock at which the contact stress is whole"},
    weakening_of<Friction>(),
    weakening_speed_of<Friction>(),
    slip_speed_of<Friction>(),
}};

}  // namespace

std::span<const Coefficient<Friction>> Friction::coefficients() { return friction_coefficients; }

Pressing law_pressing(const Friction& law, const PartCut& cut) {
  const double stress = std::min(law.stress, law.cap * cut.strength.confined);
  return {stress * cut.contact_area, std::tan(law.full_angle), sliding_of(law), law.slip_speed};
}

}  // namespace tdbd::forces
