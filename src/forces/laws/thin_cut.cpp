#include "forces/laws/thin_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angles.hpp"
#include "forces/part/directions.hpp"

namespace tdbd::forces {
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

}  // namespace tdbd::forces
