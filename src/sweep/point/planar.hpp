#pragma once

#include <nlohmann/json_fwd.hpp>

#include "simulation/case/case.hpp"

namespace tdbd::sweep {

/// What the classical planar model says of a case's bit at its advance per revolution, before any
/// drilling: advance_m, imbalance (of normal and cutting forces, over the weight),
/// imbalance_of_unit_law, mean_redundancy, cut_area_m2, largest_cut_area_m2, engaged_cutters. SI.
/// Throws InputError for a bit without cutters and a motion without an advance.
nlohmann::ordered_json planar_summary(const simulation::Case& c, double normal_ratio);

}  // namespace tdbd::sweep
