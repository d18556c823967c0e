#pragma once

#include <map>
#include <memory>
#include <string>

namespace tdbd::units {

/// Powers of the base units: {{"kg", 1}, {"m", -3}}. A plane angle counts as a dimension, "rad".
/// UDUNITS-2 treats it as a plain number, and converts seconds to 1/s by taking the reciprocal, so
/// TDBD compares dimensions itself.
using UnitPowers = std::map<std::string, int>;

/// A unit of one of the two databases.
class Unit {
 public:
  Unit() = default;
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;
  virtual ~Unit() = default;

  virtual UnitPowers powers() const = 0;

  /// Converts x from this unit to a unit of the same database and the same powers.
  virtual double convert(double x, const Unit& to) const = 0;

  /// The unit in base units, for messages: "0.5 m2.s-2". Empty if there is none.
  virtual std::string definition() const = 0;
};

/// Finds a unit of UDUNITS-2 by its name, such as "N m/rad"; null if it is unknown. Thread-safe.
std::unique_ptr<Unit> find_in_udunits(const std::string& name);

/// Finds a unit in TDBD's own table: the units used in drilling, and SI units with their prefixes.
/// It is for builds for web browsers, which lack UDUNITS-2. The test UnitTable compares both
/// databases.
std::unique_ptr<Unit> find_in_table(const std::string& name);

/// Finds a unit in the database of this build.
inline std::unique_ptr<Unit> find_unit(const std::string& name) {
#ifdef __EMSCRIPTEN__
  return find_in_table(name);
#else
  return find_in_udunits(name);
#endif
}

}  // namespace tdbd::units
