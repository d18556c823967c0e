#pragma once

#include <vector>

#include "bit/pdc/pdc_design.hpp"

namespace tdbd::bit {

/// Arc lengths (m) of the face cutters' tips, from first_radius to the end of the shoulder, where
/// the gage radius is reached: their density along the profile is 1 / (diameter (1 - overlap)),
/// raised to the next whole number of cutters, so neighbours overlap at least as asked. Closed
/// form: the overlap is linear in each region, so the count up to s is a logarithm.
std::vector<double> face_places(const PdcDesign& d);

}  // namespace tdbd::bit
