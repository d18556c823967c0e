#pragma once

#include <vector>

#include "core/config/config.hpp"
#include "dynamics/gyrostat.hpp"
#include "dynamics/loads.hpp"

namespace tdbd::simulation {

/// The body of a rotate case and its initial state.
struct BodyStart {
  dynamics::Gyrostat body;
  dynamics::RotationState state;
  std::vector<dynamics::ConeLoad> cone_loads;  ///< one for each cone
};

/// Reads [body] and [[cones]] of a case and makes the gyrostat. Mistakes are recorded in `c`; the
/// result is then valid but meaningless.
BodyStart read_body_start(Config& c);

}  // namespace tdbd::simulation
