#pragma once

#include <string>
#include <vector>

#include "simulation/step/simulation.hpp"

namespace tdbd::claims {

/// A case of cases/, with settings KEY=VALUE.
simulation::Case rock_case(const std::string& name, const std::vector<std::string>& settings);

/// A case without its last step if maintenance is due after that: a new vertex on an edge that
/// passes through the bit is inside until the next update.
simulation::Case until_an_update(simulation::Case c);

/// Drills the whole case.
simulation::Simulation drilled(const simulation::Case& c);

/// Shape quality of every triangle, from the worst on.
std::vector<double> qualities(const mesh::Surface& s);

/// Operations over moves of vertices that the page calls few: one for twenty.
inline constexpr double few = 0.05;

/// The same where flips and blunting count, too: one for ten.
inline constexpr double few_with_ours = 0.1;

/// What maintenance carried out of the thesis's operations: collapses (4.2.1), bisections (4.2.2),
/// smoothing (4.2.3).
long thesis_operations(const simulation::Simulation& s);

/// All operations of maintenance, including flips and blunting, which the thesis does not have.
long operations(const simulation::Simulation& s);

/// Volume of the gage circle over one revolution's advance, m3.
double volume_per_revolution(const simulation::Case& c);

/// Removed in a revolution (from 0), m3.
double removed_in(const simulation::Simulation& s, std::size_t revolution);

/// How far the deepest rock vertex is inside a cutting part with the bit where it is, m; 0: none
/// is.
double deepest_inside(const simulation::Case& c, const simulation::Simulation& s);

}  // namespace tdbd::claims
