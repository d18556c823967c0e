#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// Force from width and depth of cut, as in the model of Langeveld (1992), forces (8):
///   Ft = kt De depth,  Fn = kn De depth
/// RECONSTRUCTED: the thesis only calls this model "very simple". The depth of PartCut is the mean
/// thickness, so De depth is the cut area; the Langeveld model in reference/literature uses the
/// depth of the tip. Thesis: 2.1 (earlier models).
struct DepthOfCut {
  double kn = 0.0;                       ///< Pa, normal force per width and depth
  double kt = 0.0;                       ///< Pa, tangential force per width and depth
  double slip_speed = usual_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "depth-of-cut";
  static constexpr bool knows(bit::PartKind kind) { return kind == bit::PartKind::face; }
  static std::span<const Coefficient<DepthOfCut>> coefficients();
};

PartForce law_force(const DepthOfCut& law, const PartCut& cut);

}  // namespace tdbd::forces
