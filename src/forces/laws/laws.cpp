#include "forces/laws/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/types.hpp"

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

namespace {

constexpr int most_iterations = 50;
/// The error after a Newton step is less than the square of the step, both relative to t.
constexpr double converged = 1e-8;

double cosine(const GrooveCutter& c) {
  return std::cos(std::clamp(c.back_rake, -steepest_rake, steepest_rake));
}

/// t - sin t cos t, by its series for small t to avoid cancellation.
double segment(double t) {
  if (t > 0.3) return t - std::sin(t) * std::cos(t);
  const double s = 4.0 * t * t;  // the series is that of (2t - sin 2t)/2
  double sum = 1.0;
  for (const double divisor : {210.0, 156.0, 110.0, 72.0, 42.0, 20.0})
    sum = 1.0 - s / divisor * sum;
  return 2.0 / 3.0 * t * t * t * sum;
}

struct HalfAngle {
  double t = 0.0;  // rad
  int iterations = 0;
};

/// Solves segment(t) = q for t in [0, pi/2].
HalfAngle half_angle(double q) {
  HalfAngle h{.t = std::cbrt(1.5 * q)};
  while (h.t > 0.0 && h.iterations < most_iterations) {
    const double sine = std::sin(h.t), step = (segment(h.t) - q) / (2.0 * sine * sine);
    h.t -= step;
    ++h.iterations;
    if (std::abs(step) <= converged * h.t) break;
  }
  return h;
}

}  // namespace

double groove_area(const GrooveCutter& cutter, double depth) {
  const double a = cutter.diameter / 2.0, c = cosine(cutter);
  const double t = 2.0 * std::asin(std::sqrt(std::clamp(depth / (2.0 * a * c), 0.0, 1.0)));
  return a * a * segment(t) * c;
}

GrooveDepth groove_depth(const GrooveCutter& cutter, double area) {
  const double a = cutter.diameter / 2.0, c = cosine(cutter);
  const double q = std::min(area / (a * a * c), pi);
  if (q <= pi / 2.0) {
    const HalfAngle h = half_angle(q);
    const double sine = std::sin(h.t / 2.0);
    return {.depth = 2.0 * a * c * sine * sine, .iterations = h.iterations};
  }
  const HalfAngle h = half_angle(pi - q);
  const double cosine_of_rest = std::cos(h.t / 2.0);
  return {.depth = 2.0 * a * c * cosine_of_rest * cosine_of_rest, .iterations = h.iterations};
}

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

namespace {

constexpr double largest_sum = 170.0 * pi / 180.0;
constexpr double smallest_blade_angle = 10.0 * pi / 180.0;

const std::array<Coefficient<ThinCut>, 6> thin_cut_coefficients{{
    {"shear_angle", "rad", &ThinCut::shear_angle, ThinCut{}.shear_angle, Range::within(0.05, 0.8),
     "angle of the shear plane"},
    {"blade_height", "1", &ThinCut::blade_height, ThinCut{}.blade_height, Range::non_negative(),
     "height of the chip on the face over that of the cut"},
    {"interface_share", "1", &ThinCut::interface_share, ThinCut{}.interface_share,
     Range::within(0.0, 1.0), "friction angle of the face over that of the rock"},
    {"cohesion_share", "1", &ThinCut::cohesion_share, 1.0, Range::non_negative(),
     "cohesion over that of the unconfined strength"},
    {"largest_back_rake", "rad", &ThinCut::largest_back_rake, ThinCut{}.largest_back_rake,
     Range::within(0.0, 1.0), "back rake beyond which dead rock builds up before the face"},
    slip_speed_of<ThinCut>(),
}};

struct Angles {
  double blade, shear, rock, interface;  // rad: al, b, phi, delta
};

Angles angles(const ThinCut& law, const PartCut& cut) {
  Angles a{.blade = pi / 2.0 + std::min(cut.back_rake, law.largest_back_rake),
           .shear = law.shear_angle,
           .rock = cut.strength.friction_angle,
           .interface = law.interface_share * cut.strength.friction_angle};
  a.blade = std::min(a.blade, largest_sum - a.shear - a.rock - a.interface);
  a.blade = std::max(a.blade, smallest_blade_angle);
  return a;
}

double cohesion(const Strength& s) {
  return s.unconfined * (1.0 - std::sin(s.friction_angle)) / (2.0 * std::cos(s.friction_angle));
}

}  // namespace

std::span<const Coefficient<ThinCut>> ThinCut::coefficients() { return thin_cut_coefficients; }

PartForce law_force(const ThinCut& law, const PartCut& cut) {
  const auto [al, b, phi, delta] = angles(law, cut);
  const double C = law.cohesion_share * cohesion(cut.strength) * cut.cut_area / std::sin(b);
  const double W1 = cut.strength.pressure * cut.cut_area / std::sin(b);
  const double W2 = cut.strength.pressure * cut.cut_area * law.blade_height / std::sin(al);
  const double K2 = (W2 * std::sin(al + b + phi) + W1 * std::sin(phi) + C * std::cos(phi)) /
                    std::sin(al + b + phi + delta);
  const double Ft = -W2 * std::sin(al) + K2 * std::sin(al + delta);
  const double Fn = W2 * std::cos(al) - K2 * std::cos(al + delta);
  return cutting_force(cut, std::max(Ft, 0.0), std::max(Fn, 0.0), law.slip_speed);
}

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
