#pragma once

#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case_warning.hpp"
#include "simulation/case/chain_statics.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// What of a chain is checked for doubtful values.
struct DoubtfulChain {
  const StringPlan& string;
  const string::Chain& chain;
  std::vector<StaticLoad> loads;
  double hole_diameter = 0.0;      ///< m; 0: unknown
  double passing_frequency = 0.0;  ///< of the bit's blades, Hz; 0: none
};

/// Warns where a static load compresses the string beyond its sinusoidal buckling, 2 sqrt(E I w sin/clearance),
/// which a soft string does not model; and where the waves that the bit's blades excite have fewer than ten
/// elements to a wavelength.
std::vector<CaseWarning> chain_warnings(const Config& c, const DoubtfulChain& doubtful);

}  // namespace tdbd::simulation
