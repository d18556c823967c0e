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

/// The case `cases/NAME.toml` at this edge length (m) after its first revolution: a conforming
/// start has no steps in front of the cutters yet, one turn of the bit makes them all. `settings`:
/// further KEY=VALUE of the case.
Drilling after_one_revolution(const std::string& name, double edge_length,
                              std::vector<std::string> settings = {});

/// The pose of the bit `steps` (or a part of one) after what is drilled.
Pose pose_after(const Drilling& d, double steps);

/// Drills this many steps, with ledger and maintenance.
void drill(Drilling& d, long steps);

/// CPU time of this process, s: does not count what other programs take.
double cpu_seconds();

}  // namespace tdbd::bench
