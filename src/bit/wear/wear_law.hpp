#pragma once

#include <string_view>
#include <variant>
#include <vector>

namespace tdbd::bit {

/// What rubs on a surface of the bit at an instant.
struct WearContact {
  double normal_force = 0.0;  ///< N, between the surface and the rock
  double speed = 0.0;         ///< m/s, of the surface over the rock
  double temperature = 0.0;   ///< K, of the surface
};

/// A surface that does not wear.
struct NoWear {
  static constexpr std::string_view name = "none";
  bool operator==(const NoWear&) const = default;
};

/// Archard: the worn volume is proportional to normal force and path, and inversely to hardness.
struct SlidingWear {
  static constexpr std::string_view name = "sliding";
  double coefficient = 0.0;  ///< k, 1
  double hardness = 0.0;     ///< H, Pa, of the surface, above 0
  bool operator==(const SlidingWear&) const = default;
};

/// Glowka's thermal wear: sliding wear that is faster above a threshold of the temperature. That a
/// threshold exists is in the abstract of SPE 14222; the exponential form is ours.
struct ThermalWear {
  static constexpr std::string_view name = "thermal";
  SlidingWear sliding;
  double threshold = 0.0;  ///< K
  double growth = 0.0;     ///< K, above 0: an excess by this multiplies the rate by e
  bool operator==(const ThermalWear&) const = default;
};

/// Measured wear: volume per work of the normal force over temperature. Linear between the
/// temperatures, constant beyond the first and the last.
struct TableWear {
  static constexpr std::string_view name = "table";
  std::vector<double> temperatures;  ///< K, rising
  std::vector<double> rates;         ///< m3/(N m), one for each temperature
  bool operator==(const TableWear&) const = default;
};

using WearLaw = std::variant<NoWear, SlidingWear, ThermalWear, TableWear>;

/// The worn volume per path and normal force, m3/(N m), at this temperature (K); bit (16).
double wear_coefficient(const WearLaw& law, double temperature);

/// The rate of worn volume, m3/s: C(T) Fn v; bit (16).
double wear_rate(const WearLaw& law, const WearContact& contact);

/// How a wear flat heats: the heat of friction divides between the rock, a half-space that slides
/// past, and the cutter, a resistance. The formula is from memory of Glowka and Stone.
struct FlatHeating {
  double friction = 0.0;              ///< mu, 1
  double rock_conductivity = 0.0;     ///< W/(m K), above 0
  double rock_diffusivity = 0.0;      ///< m2/s
  double cutter_resistance = 0.0;     ///< K m2/W, from the flat to the drilling fluid
  double fluid_temperature = 293.15;  ///< K
};

/// What heats a flat.
struct FlatContact {
  double normal_force = 0.0;  ///< N
  double speed = 0.0;         ///< m/s
  double area = 0.0;          ///< m2, on which the force acts
  double length = 0.0;        ///< m, of the flat along the motion
};

/// Mean temperature of a flat, K; bit (17). That of the fluid where no force, area, or motion heats it.
double flat_temperature(const FlatHeating& heating, const FlatContact& contact);

}  // namespace tdbd::bit
