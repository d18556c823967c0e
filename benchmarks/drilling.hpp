#pragma once

#include <string>
#include <vector>

#include "simulation/step/simulation.hpp"

namespace tdbd::bench {

/// A case and how far it is drilled.
struct Drilling {
  simulation::Case plan;
  simulation::Simulation run;
};

/// The case `cases/NAME.toml` at this edge length (m), read. `settings`: further KEY=VALUE of the
/// case.
simulation::Case read_plan(const std::string& name, double edge_length,
                           std::vector<std::string> settings);

/// The same at t = 0.
Drilling start_drilling(const std::string& name, double edge_length,
                        std::vector<std::string> settings);

/// The same after its first revolution: a conforming start has no steps in front of the cutters
/// yet, one turn of the bit makes them all.
Drilling after_one_revolution(const std::string& name, double edge_length,
                              std::vector<std::string> settings = {});

/// Steps of one turn of the bit; of a bit that forces turn, at the speed that its top is given.
long steps_of_a_revolution(const simulation::Case& plan);

/// The pose of the bit `steps` (or a part of one) after what is drilled.
Pose pose_after(const Drilling& d, double steps);

/// Drills this many steps, with ledger and maintenance.
void drill(Drilling& d, long steps);

/// CPU time of this process, s: does not count what other programs take.
double cpu_seconds();

/// Seconds of the wall since some moment.
double wall_seconds();

}  // namespace tdbd::bench
