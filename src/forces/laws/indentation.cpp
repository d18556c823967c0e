#include "forces/laws/indentation.hpp"

#include <array>

#include "forces/part/directions.hpp"

namespace tdbd::forces {
namespace {

const std::array<Coefficient<Indentation>, 5> table{{
    {"ratio", "1", &Indentation::ratio, 1.0, Range::positive(),
     "crushing pressure over the confined strength"},
    {"mu", "1", &Indentation::mu, 0.3, Range::non_negative(), "friction between tooth and rock"},
    {"weakening", "1", &Indentation::weakening, 0.0, Range::within(0.0, 1.0),
     "share of mu that is lost at high speed"},
    {"weakening_speed", "m/s", &Indentation::weakening_speed, 1.0, Range::positive(),
     "speed at which most of that is lost"},
    {"slip_speed", "m/s", &Indentation::slip_speed, usual_slip_speed, Range::non_negative(),
     "speed below which the force fades"},
}};

}  // namespace

std::span<const Coefficient<Indentation>> Indentation::coefficients() { return table; }

PartForce law_force(const Indentation& law, const PartCut& cut) {
  return pressing_force(cut, law.ratio * cut.strength.confined * cut.contact_area,
                        {law.mu, law.weakening, law.weakening_speed}, law.slip_speed);
}

}  // namespace tdbd::forces
