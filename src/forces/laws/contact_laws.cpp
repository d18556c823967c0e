#include "forces/laws/contact_laws.hpp"

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

namespace {

const std::array<Coefficient<Indentation>, 5> indentation_coefficients{{
    {"ratio", "1", &Indentation::ratio, 1.0, Range::positive(),
     "crushing pressure over the confined strength"},
    {"mu", "1", &Indentation::mu, 0.3, Range::non_negative(), "friction between tooth and rock"},
    weakening_of<Indentation>(),
    weakening_speed_of<Indentation>(),
    slip_speed_of<Indentation>(),
}};

}  // namespace

std::span<const Coefficient<Indentation>> Indentation::coefficients() {
  return indentation_coefficients;
}

Pressing law_pressing(const Indentation& law, const PartCut& cut) {
  return {law.ratio * cut.strength.confined * cut.contact_area, 0.0, sliding_of(law),
          law.slip_speed};
}

}  // namespace tdbd::forces
