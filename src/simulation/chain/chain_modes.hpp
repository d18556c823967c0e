#pragma once

#include <vector>

#include "simulation/case/read_chain.hpp"
#include "string/modes.hpp"

namespace tdbd::simulation {

/// The first three free vibrations of each kind, the top standing still, the bit off bottom.
struct ChainModes {
  std::vector<string::Mode> axial, torsional;
};

inline ChainModes chain_modes(const ChainPlan& p) {
  constexpr int count = 3;
  std::vector<double> mass = p.chain.elements.mass, inertia = p.chain.elements.inertia;
  mass.back() = p.bit.mass;
  inertia.back() = p.bit.inertia;
  ChainModes m;
  if (p.chain.directions != string::Directions::torsion)
    m.axial = string::lowest_modes(p.chain.elements.axial, mass, count);
  if (p.chain.directions != string::Directions::axial)
    m.torsional = string::lowest_modes(p.chain.elements.torsional, inertia, count);
  return m;
}

}  // namespace tdbd::simulation
