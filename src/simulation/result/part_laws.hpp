#pragma once

#include <vector>

#include "bit/report/area_report.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// The resolved force law of every part, for bit.json; empty if the run computes no forces.
std::vector<bit::PartLaw> part_laws(const Case& c);

}  // namespace tdbd::simulation
