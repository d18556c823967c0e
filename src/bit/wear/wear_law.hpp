#pragma once

#include <string_view>
#include <variant>
#include <vector>

namespace tdbd::bit {

/// Contact of a surface of the bit with rock at one time.
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

/// Archard's law: the worn volume is proportional to normal force and path, and inversely
/// proportional to hardness.
struct SlidingWear {
  static constexpr std::string_view name = "sliding";
  double coefficient = 0.0;  ///< k, 1
  double hardness = 0.0;     ///< H, Pa, of the surface, above 0
  bool operator==(const SlidingWear&) const = default;
};

/// Glowka's thermal wear: sliding wear that is faster above a threshold temperature. The existence
/// of a threshold is stated in the abstract of SPE 14222; the exponential form is not from there.
struct ThermalWear {
  static constexpr std::string_view name = "thermal";
  SlidingWear sliding;
  double threshold = 0.0;  ///< K
  double growth = 0.0;     ///< K, above 0: an excess by this amount multiplies the rate by e
  bool operator==(const ThermalWear&) const = default;
};

/// Measured wear: volume per work of the normal force as a function of temperature. Linear between
/// the temperatures, constant below the first and above the last.
struct TableWear {
  static constexpr std::string_view name = "table";
  std::vector<double> temperatures;  ///< K, ascending
  std::vector<double> rates;         ///< m3/(N m), one for each temperature
  bool operator==(const TableWear&) const = default;
};

using WearLaw = std::variant<NoWear, SlidingWear, ThermalWear, TableWear>;

/// The worn volume per path and normal force, m3/(N m), at this temperature (K); bit (16).
double wear_coefficient(const WearLaw& law, double temperature);

/// The rate of worn volume, m3/s: C(T) Fn v; bit (16).
double wear_rate(const WearLaw& law, const WearContact& contact);

/// Heating of a wear flat. The heat of friction is divided between the rock, a half-space that
/// slides past, and the cutter, a thermal resistance. The formula is from memory of Glowka and
/// Stone.
struct FlatHeating {
  double friction = 0.15;             ///< mu, 1
  double rock_conductivity = 3.5;     ///< W/(m K), above 0
  double rock_diffusivity = 1.5e-6;   ///< m2/s
  double cutter_resistance = 0.3e-4;  ///< K m2/W, from the flat to the drilling fluid
  double fluid_temperature = 293.15;  ///< K
};

/// The contact that heats a flat.
struct FlatContact {
  double normal_force = 0.0;  ///< N
  double speed = 0.0;         ///< m/s
  double area = 0.0;          ///< m2, on which the force acts
  double length = 0.0;        ///< m, of the flat along the motion
};

/// Mean temperature of a flat, K; bit (17). Equal to that of the fluid without force, area or
/// motion.
double flat_temperature(const FlatHeating& heating, const FlatContact& contact);

}  // namespace tdbd::bit
