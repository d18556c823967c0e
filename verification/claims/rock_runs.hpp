#pragma once

#include <string>
#include <vector>

#include "simulation/simulation.hpp"

namespace tdbd::claims {

/// A case of cases/, with settings KEY=VALUE.
simulation::Case rock_case(const std::string& name, const std::vector<std::string>& settings);

/// Drills the whole case.
simulation::Simulation drilled(const simulation::Case& c);

/// Shape quality of every triangle, from the worst on.
std::vector<double> qualities(const mesh::Surface& s);

/// Operations over moves of vertices that the page calls few: one for ten.
inline constexpr double few = 0.1;

/// Bisections, collapses and all else that maintenance carried out.
long operations(const simulation::Case& c, const simulation::Simulation& s);

/// Volume of the gage circle over one revolution's advance, m3.
double volume_per_revolution(const simulation::Case& c);

/// Removed in a revolution (from 0), m3.
double removed_in(const simulation::Simulation& s, std::size_t revolution);

/// How far the deepest rock vertex is inside a cutting part with the bit where it is, m; 0: none
/// is.
double deepest_inside(const simulation::Case& c, const simulation::Simulation& s);

}  // namespace tdbd::claims
