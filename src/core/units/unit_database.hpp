#pragma once

#include <map>
#include <memory>
#include <string>

namespace tdbd::units {

/// Powers of the base units: {{"kg", 1}, {"m", -3}}. A plane angle counts, as "rad": UDUNITS-2 treats it as a plain
/// number, and converts seconds to 1/s by taking the reciprocal, so that we compare dimensions ourselves.
using UnitPowers = std::map<std::string, int>;

/// A unit as one of the two databases has it.
class Unit {
 public:
  Unit() = default;
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;
  virtual ~Unit() = default;

  virtual UnitPowers powers() const = 0;

  /// x of this unit in another of the same database and the same powers.
  virtual double convert(double x, const Unit& to) const = 0;

  /// "0.5 m2.s-2": in base units, for messages; empty if it has none.
  virtual std::string definition() const = 0;
};

/// A unit of UDUNITS-2 by its name, "N m/rad"; null where it is unknown. Threads take turns.
std::unique_ptr<Unit> find_in_udunits(const std::string& name);

/// The same of a table of our own: what drillers write, and SI with its prefixes. Programs for browsers have no
/// UDUNITS-2; UnitTable holds it against that.
std::unique_ptr<Unit> find_in_table(const std::string& name);

/// Of the database that this program has.
inline std::unique_ptr<Unit> find_unit(const std::string& name) {
#ifdef __EMSCRIPTEN__
  return find_in_table(name);
#else
  return find_in_udunits(name);
#endif
}

}  // namespace tdbd::units
