#include "forces/laws/hanson_hansen.hpp"

#include <algorithm>
#include <cmath>

#include "forces/part/directions.hpp"

namespace tdbd::forces {
namespace {

using bit::PartKind;
using Terms = std::array<double, hanson_hansen_terms>;

constexpr bool on_chamfer(PartKind kind) { return kind == PartKind::chamfer; }

/// The surfaces of a cutter other than face and chamfer.
constexpr bool on_others(PartKind kind) {
  return HansonHansen::knows(kind) && !on_face(kind) && !on_chamfer(kind);
}

const std::array<Coefficient<HansonHansen>, 11> hanson_hansen_coefficients{{
    {"A1",
     "1",
     &HansonHansen::A1,
     {},
     Range::non_negative(),
     "tangential stress of a face over the confined strength",
     on_face},
    {"A2", "1", &HansonHansen::A2, 0.0, Range::non_negative(), "its growth with tan(back rake)",
     on_face},
    {"A3",
     "rad",
     &HansonHansen::A3,
     {},
     Range::within(0.0, 1.0),
     "friction angle of a face",
     on_face},
    {"A4", "1", &HansonHansen::A4, 0.0, Range::non_negative(),
     "stress along the edge over the confined strength: only te A4 acts", on_face},
    {"te", "m", &HansonHansen::te, 1e-4, Range::non_negative(),
     "length scale of A4: only their product acts; keep it fixed", on_face},
    {"A5", "1", &HansonHansen::A5, 0.0, Range::non_negative(),
     "contact stress of a chamfer over the confined strength", on_chamfer},
    {"A6", "1", &HansonHansen::A6, 0.0, Range::non_negative(), "friction of a chamfer", on_chamfer},
    {"A7", "1", &HansonHansen::A7, 0.0, Range::non_negative(),
     "contact stress of other surfaces of a cutter over the confined strength", on_others},
    {"A8", "1", &HansonHansen::A8, 0.0, Range::non_negative(), "friction of other surfaces",
     on_others},
    {"pressure_share", "1", &HansonHansen::pressure_share, 1.0, Range::within(0.0, 2.0),
     "share of the strength's growth with pressure that counts"},
    slip_speed_of<HansonHansen>(),
}};

double strength(const HansonHansen& law, const Strength& s) {
  return s.unconfined + law.pressure_share * (s.confined - s.unconfined);
}

/// tan of an angle that is first limited to +-80 degrees.
double bounded_tan(double angle) {
  return std::tan(std::clamp(angle, -steepest_rake, steepest_rake));
}

/// B2: ratio of normal to tangential force of a face.
double face_ratio(const HansonHansen& law, const PartCut& cut) {
  return std::max(0.0, bounded_tan(cut.back_rake + law.A3));
}

/// Forces on a face or chamfer if each factor is 1, N, by term.
struct UnitForces {
  Terms tangential{}, normal{};
};

UnitForces unit_forces(const HansonHansen& law, const PartCut& cut) {
  const double Scc = strength(law, cut.strength);
  UnitForces unit;
  if (cut.kind == PartKind::face) {
    const double leaning = std::max(0.0, bounded_tan(cut.back_rake));
    const double area = Scc * cut.cut_area;
    unit.tangential = {area, area * leaning, Scc * law.te * cut.engaged_edge};
    const double B2 = face_ratio(law, cut);
    for (int k = 0; k < 3; ++k) unit.normal[k] = B2 * unit.tangential[k];
    return unit;
  }
  unit.normal[3] = unit.tangential[4] = Scc * cut.contact_area;
  return unit;
}

double sum_of(const Terms& factors, const Terms& terms) {
  double sum = 0.0;
  for (int k = 0; k < hanson_hansen_terms; ++k) sum += factors[k] * terms[k];
  return sum;
}

}  // namespace

std::span<const Coefficient<HansonHansen>> HansonHansen::coefficients() {
  return hanson_hansen_coefficients;
}

Terms linear_coefficients(const HansonHansen& law) {
  return {law.A1, law.A1 * law.A2, law.A4, law.A5, law.A5 * law.A6, law.A7, law.A7 * law.A8};
}

PartForce law_force(const HansonHansen& law, const PartCut& cut) {
  const Terms factors = linear_coefficients(law);
  const UnitForces unit = unit_forces(law, cut);
  return cutting_force(cut, sum_of(factors, unit.tangential), sum_of(factors, unit.normal),
                       law.slip_speed);
}

Pressing law_pressing(const HansonHansen& law, const PartCut& cut) {
  const double limit = law.A7 * strength(law, cut.strength) * cut.contact_area;
  return {limit, 0.0, {.mu = law.A8}, law.slip_speed};
}

std::array<Vec3, hanson_hansen_terms> force_basis(const HansonHansen& law, const PartCut& cut) {
  if (law.presses(cut.kind)) {
    HansonHansen unit = law;
    unit.A7 = unit.A8 = 1.0;
    const Pressing rough = law_pressing(unit, cut);
    unit.A8 = 0.0;
    const Vec3 normal = pressing_force(cut, law_pressing(unit, cut)).force;
    std::array<Vec3, hanson_hansen_terms> basis;
    basis.fill(Vec3::Zero());
    basis[5] = normal;
    basis[6] = pressing_force(cut, rough).force - normal;
    return basis;
  }
  const UnitForces unit = unit_forces(law, cut);
  const CutFrame frame = cut_frame(cut.velocity, cut.normal);
  const double share = slip_share(cut.velocity.norm(), law.slip_speed);
  std::array<Vec3, hanson_hansen_terms> basis;
  for (int k = 0; k < hanson_hansen_terms; ++k)
    basis[k] = -share * (unit.tangential[k] * frame.e1 + unit.normal[k] * frame.e2);
  return basis;
}

}  // namespace tdbd::forces
