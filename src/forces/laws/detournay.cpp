#include "forces/laws/detournay.hpp"

#include <algorithm>
#include <array>

#include "forces/part/directions.hpp"

namespace tdbd::forces {
namespace {

const std::array<Coefficient<Detournay>, 9> detournay_coefficients{{
    {"eps", "Pa", &Detournay::eps, {}, Range::positive(), "intrinsic specific energy", on_face},
    {"zeta",
     "1",
     &Detournay::zeta,
     {},
     Range::non_negative(),
     "normal over tangential force of a sharp face",
     on_face},
    {"sigma", "Pa", &Detournay::sigma, 0.0, Range::non_negative(), "contact stress of a wear flat"},
    {"mu", "1", &Detournay::mu, 0.0, Range::non_negative(), "friction of a wear flat"},
    {"l", "m", &Detournay::l, 0.0, Range::non_negative(),
     "length of the wear flat along the motion, where the mesh has none", on_face},
    {"kappa", "1", &Detournay::kappa, 5.0, Range::non_negative(),
     "growth of the contact's length with the depth of cut", on_face},
    weakening_of<Detournay>(),
    weakening_speed_of<Detournay>(),
    slip_speed_of<Detournay>(),
}};

}  // namespace

std::span<const Coefficient<Detournay>> Detournay::coefficients() { return detournay_coefficients; }

PartForce law_force(const Detournay& law, const PartCut& cut) {
  const bool is_face = cut.kind == bit::PartKind::face;
  const double flat =
      is_face ? cut.engaged_edge * std::min(law.kappa * cut.depth, law.l) : cut.contact_area;
  const double cutting = is_face ? law.eps * cut.cut_area : 0.0;
  const double rubbing = law.sigma * flat;
  const double mu = friction_at(sliding_of(law), cut.velocity.norm());
  return cutting_force(cut, cutting + mu * rubbing, law.zeta * cutting + rubbing, law.slip_speed);
}

Pressing law_pressing(const Detournay& law, const PartCut& cut) {
  return {law.sigma * cut.contact_area, 0.0, sliding_of(law), law.slip_speed};
}

}  // namespace tdbd::forces
