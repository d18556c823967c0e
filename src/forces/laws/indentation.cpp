#include "forces/laws/indentation.hpp"

#include <array>

#include "forces/part/directions.hpp"

namespace tdbd::forces {
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

PartForce law_force(const Indentation& law, const PartCut& cut) {
  return pressing_force(cut, law.ratio * cut.strength.confined * cut.contact_area, sliding_of(law),
                        law.slip_speed);
}

}  // namespace tdbd::forces
