#pragma once

#include "dynamics/drilling/drilling_system.hpp"

namespace tdbd::simulation {

/// What drives a bit that drills by itself (formulation 4 to 6; thesis: eqs. 2.1 to 2.3).
struct DrillingPlan {
  dynamics::DrillingSystem system;
  dynamics::DrillingState start;
};

}  // namespace tdbd::simulation
