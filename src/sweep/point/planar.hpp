#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "bit/profile/bit_analysis.hpp"
#include "core/types.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::sweep {

/// The loads of a bit that drills steadily, by the planar model.
struct PlanarLoads {
  Vec3 force_B = Vec3::Zero();  ///< N, of the rock on the bit, bit frame
  double torque = 0.0;          ///< N m, about the bit's axis, against the rotation
};

/// Evaluates the force laws of a case for what each cutter cuts in the radial plane, sweep (1): its
/// face with the cut area and the engaged edge, and its chamfer with the contact behind that edge.
/// Law, rock and measures are those of `tdbd run` at the start of the case; area laws
/// ([forces.areas]) count. Wear flats, cutter bodies, gage pads and rubbing parts have no force
/// here. `indices`: the cutters of the engagement, as in bit::cutting_at_start. `advance`: m per
/// revolution, > 0. Requires a case with [forces] and a rotary speed > 0.
PlanarLoads planar_loads(const simulation::Case& c, const std::vector<int>& indices,
                         const bit::Engagement& e, double advance);

/// Evaluates the planar model for a case's bit at its advance per revolution, without drilling:
/// advance_m, imbalance (lateral force over the weight), imbalance_of_normal_ratio (the classical
/// model, in which the normal force is `normal_ratio` times the cutting force),
/// imbalance_of_unit_law, wob_n, tob_n_m, mean_redundancy, cut_area_m2, largest_cut_area_m2,
/// engaged_cutters. SI. `imbalance` is that of the case's force law (planar_loads). Without
/// [forces] it is imbalance_of_normal_ratio, and wob_n and tob_n_m are null. Throws InputError for
/// a bit without cutters or a motion without an advance.
nlohmann::ordered_json planar_summary(const simulation::Case& c, double normal_ratio);

}  // namespace tdbd::sweep
