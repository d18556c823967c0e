#pragma once

#include <optional>
#include <string>

#include "simulation/step/simulation.hpp"

namespace tdbd::web {

/// The one drilling that a page, or a test under node, holds.
struct Session {
  simulation::Case of;
  simulation::Simulation state;
};

/// The constants of a case for the page, as JSON: title, hash, warnings, resolved case, steps, step
/// (s), gage radius (m), version, and the parts with name, kind and body (0: the bit; 1 + k: its
/// cone k).
std::string facts_json(const Session& s);

/// Where the drilling is, as JSON in SI: steps, done, time, revolutions, removed volume in all and by part, WOB and TOB
/// (null where they are no numbers), triangles, and the pose of each body as three rows of four numbers (frame W over frame B at rest).
std::string look_json(const Session& s);

/// N, that the bit presses on the rock with, and N m about z, in the last step. Not a number without forces or a step.
double weight_on_bit(const Session& s);
double torque_on_bit(const Session& s);

}  // namespace tdbd::web
