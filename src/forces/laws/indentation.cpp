#include "forces/laws/indentation.hpp"

#include <array>

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

Pressing law_pressing(const Indentation& law, const PartCut& cut) {
  return {law.ratio * cut.strength.confined * cut.contact_area, 0.0, sliding_of(law),
          law.slip_speed};
}

}  // namespace tdbd::forces
