#pragma once

#include <string>
#include <vector>

#include "simulation/step/simulation.hpp"

namespace tdbd::bench {

/// A case and its simulation.
struct Drilling {
  simulation::Case plan;
  simulation::Simulation run;
};

/// Reads the case `cases/NAME.toml` with this edge length (m). `settings`: further KEY=VALUE of the
/// case.
simulation::Case read_plan(const std::string& name, double edge_length,
                           std::vector<std::string> settings);

/// Starts the case at t = 0.
Drilling start_drilling(const std::string& name, double edge_length,
                        std::vector<std::string> settings);

/// Drills the case for its first revolution. A conforming start has no steps in front of the
/// cutters yet; one turn of the bit makes all of them.
Drilling after_one_revolution(const std::string& name, double edge_length,
                              std::vector<std::string> settings = {});

/// Number of steps of one revolution; for a bit that is driven by forces, at the speed of its top.
long steps_of_a_revolution(const simulation::Case& plan);

/// The pose of the bit `steps` steps (or a fraction of one) after the present state.
Pose pose_after(const Drilling& d, double steps);

/// Drills this number of steps, with ledger and maintenance.
void drill(Drilling& d, long steps);

/// CPU time of this process, s. Does not include other programs.
double cpu_seconds();

/// Wall time, s, from an arbitrary origin.
double wall_seconds();

}  // namespace tdbd::bench
