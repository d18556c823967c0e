#include "reference/literature/drag/wear/glowka_wear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::reference {
namespace {

const double wear_root_pi = std::sqrt(std::numbers::pi);

/// sin t - t cos t - sin^3 t/3, whose first term is 2/15 t^5. Uses its series where the difference
/// would cancel.
double segment_moment(double t) {
  constexpr double series_below = 0.5;
  if (t > series_below) return std::sin(t) - t * std::cos(t) - std::pow(std::sin(t), 3.0) / 3.0;
  double sum = 0.0, power = std::pow(t, 5.0) / 120.0, nine = 81.0;  // t^(2k+1)/(2k+1)!, 9^k
  for (int k = 2; k < 10; ++k) {
    sum += (k % 2 == 0 ? power : -power) * (0.75 - (2.0 * k + 1.0) + 0.25 * nine);
    power *= t * t / ((2.0 * k + 2.0) * (2.0 * k + 3.0));
    nine *= 9.0;
  }
  return sum;
}

}  // namespace

double flat_area(const GlowkaFace& face, double worn) {
  return segment_area(face.radius, worn) / std::sin(face.back_rake);
}

double flat_length(const GlowkaFace& face, double worn) { return worn / std::sin(face.back_rake); }

double worn_volume(const GlowkaFace& face, double worn) {
  const double a = face.radius, y = std::clamp(worn, 0.0, 2.0 * a);
  const double t = 2.0 * std::asin(std::sqrt(y / (2.0 * a)));  // y = a (1 - cos t)
  return a * a * a * segment_moment(t) / std::tan(face.back_rake);
}

double flat_temperature(const FlatHeat& heat, double normal_force, double speed, double area,
                        double length) {
  const double flux = heat.friction * normal_force * speed / area;
  const double rock = 4.0 / (3.0 * wear_root_pi) *
                      std::sqrt(heat.rock_diffusivity * length / speed) / heat.rock_conductivity;
  const double f = heat.cutter_resistance;
  return heat.fluid_temperature + flux * f * rock / (f + rock);
}

double wear_coefficient(const WearLaw& law, double temperature) {
  return law.coefficient * std::exp(std::max(0.0, temperature - law.threshold) / law.growth);
}

double wear_speed(const WearLaw& law, const GlowkaFace& face, double temperature, double stress,
                  double speed) {
  return wear_coefficient(law, temperature) * stress * speed / std::cos(face.back_rake);
}

}  // namespace tdbd::reference
