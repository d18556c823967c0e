#pragma once

#include <numbers>

#include "string/chain.hpp"
#include "string/simple_bit.hpp"

/// Strings and wells of the tests.
namespace tdbd::string {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double rpm = std::numbers::pi / 30.0;

/// Without mud.
inline Section steel(double length, double outer, double inner, double contact = 0.0,
                     double buoyancy = 1.0) {
  Section s = pipe(length, {outer, inner, contact > 0.0 ? contact : outer}, {}, 0.0, {});
  s.weight *= buoyancy;
  return s;
}

inline Section drill_pipe(double length) { return steel(length, 0.127, 0.1086); }
inline Section collars(double length) { return steel(length, 0.1651, 0.0714); }

/// Well A of Aarsnes and Shor: 2270 m of pipe, 230 m of collars; side forces by weight alone.
std::vector<Section> well_a_sections();

/// Kick off at 500 m, 3 deg in 30 m to 60 deg, straight to 2500 m.
Survey build_and_hold();
std::vector<Section> plain_build_and_hold();  ///< all drill pipe, buoyancy 0.87
std::vector<Section> three_sections();        ///< pipe, heavy pipe, collars, buoyancy 0.87

Chain make_chain(const std::vector<Section>& sections, const Survey& survey, double friction,
                 int elements);

/// A chain at rest, or at its steady start, with its bit; ready to step.
struct Running {
  BitOnChain state;
  ChainWork work;
};
Running at_rest(const Chain& chain);

}  // namespace tdbd::string
