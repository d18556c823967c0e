#pragma once

#include "dynamics/drilling/drilling_step.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/implicit_loads.hpp"

namespace tdbd::simulation {

/// Result of the implicit solution of a step.
struct ImplicitOutcome {
  double steepness = 0.0;  ///< of the laws relative to the compliance of the step; up to 1, a bound
  bool is_implicit = false;  ///< whether the impulse was implicit
  Search search;
};

/// Work data, reused between steps.
struct ImplicitStepWork {
  dynamics::Response response;
  dynamics::ResponseWork responding;
  BitVelocity last_drift;  ///< relative to the rock
  ImplicitWork implicit;
};

/// Statistics of the implicit steps, for the summary.
struct ImplicitStatistics {
  long steps = 0;
  long unsettled = 0;  ///< steps whose search did not converge: implicit with the last secants
  long most_rounds = 0;

  template <class Archive>
  void serialize(Archive& a) {
    a(steps, unsettled, most_rounds);
  }
};

void add(const ImplicitOutcome& step, ImplicitStatistics& statistics);

/// A step whose loads are to be found: the motion at its closing kick, and what its parts cut.
struct LoadedMotion {
  const Case& c;
  Pose X_WB;  ///< of the bit relative to the rock, at which the cuts were measured
  double dt;  ///< s
  const dynamics::Drilling& drive;
  const std::vector<CutOfPart>& cuts;
};

/// Computes the loads of a bit at rest or nearly at rest implicitly, simulation (7), (8). An
/// addition of TDBD [+]. At rest the slope of a law over velocity is so steep that an explicit
/// impulse would overshoot in every step, and the weight on bit would oscillate with an amplitude
/// of its own size. If the steepness at the velocity of the last drift exceeds 1, `loads` and
/// `velocity` become those at the velocity of the next drift. Otherwise the result reports that
/// the step is explicit, and both are unchanged.
ImplicitOutcome solve_implicitly(const LoadedMotion& motion, dynamics::DrillingWork& drive_work,
                                 ImplicitStepWork& work, BitLoads& loads, BitVelocity& velocity);

/// Computes the loads of the opening kick of a run, at the velocity of the first drift.
void opening_loads(const LoadedMotion& motion, dynamics::DrillingWork& drive_work,
                   ImplicitStepWork& work, BitLoads& loads);

}  // namespace tdbd::simulation
