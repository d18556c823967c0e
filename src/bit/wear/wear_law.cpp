#include "bit/wear/wear_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::bit {
namespace {

double coefficient_at(const NoWear&, double) { return 0.0; }

double coefficient_at(const SlidingWear& law, double) { return law.coefficient / law.hardness; }

double coefficient_at(const ThermalWear& law, double temperature) {
  const double excess = std::max(0.0, temperature - law.threshold);
  return coefficient_at(law.sliding, temperature) * std::exp(excess / law.growth);
}

double coefficient_at(const TableWear& law, double temperature) {
  const auto above = std::ranges::upper_bound(law.temperatures, temperature);
  if (above == law.temperatures.begin()) return law.rates.front();
  if (above == law.temperatures.end()) return law.rates.back();
  const auto i = static_cast<std::size_t>(above - law.temperatures.begin());
  const double w = (temperature - law.temperatures[i - 1]) / (*above - law.temperatures[i - 1]);
  return std::lerp(law.rates[i - 1], law.rates[i], w);
}

}  // namespace

double wear_coefficient(const WearLaw& law, double temperature) {
  return std::visit([temperature](const auto& l) { return coefficient_at(l, temperature); }, law);
}

double wear_rate(const WearLaw& law, const WearContact& c) {
  return wear_coefficient(law, c.temperature) * c.normal_force * c.speed;
}

double flat_temperature(const FlatHeating& heating, const FlatContact& c) {
  if (!(c.normal_force > 0.0) || !(c.area > 0.0) || !(c.speed > 0.0))
    return heating.fluid_temperature;
  const double flux = heating.friction * c.normal_force * c.speed / c.area;
  const double passing = c.length / c.speed;  // s, for which a point of the rock is heated
  const double rock = 4.0 / 3.0 * std::sqrt(heating.rock_diffusivity * passing / std::numbers::pi) /
                      heating.rock_conductivity;
  const double cutter = heating.cutter_resistance;
  if (!(rock + cutter > 0.0)) return heating.fluid_temperature;
  return heating.fluid_temperature + flux * rock * cutter / (rock + cutter);
}

}  // namespace tdbd::bit
