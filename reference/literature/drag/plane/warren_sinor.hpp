#pragma once

#include <numbers>
#include <vector>

#include "reference/literature/drag/drag_law.hpp"
#include "reference/literature/drag/plane/planar_outline.hpp"

namespace tdbd::reference {

/// The drag-bit model of Warren and Sinor (1986, SPE 15618). Thesis: 2.1, "calculates the WOB, TOB,
/// imbalance force, and volume of rock removed ... the rock surface can be represented as a single
/// plane". Known: kinematic, no lateral motion, one plane; a penetrating and a cutting force on
/// each cutter, whose radial parts sum to the imbalance (US 4,815,342). Reconstructed: the law of
/// the forces (linear in the area; back rake acts only through zeta) and of the areas (planar_cut).
/// No helix, no transient, no rubbing body.

struct WarrenSinorOptions {
  OutlineForm form = OutlineForm::planar;
  double column = 0.05e-3;           ///< m, of radius
  std::vector<double> normal_ratio;  ///< zeta of each cutter; empty: the rock's value for all
  std::vector<double> flat_area;     ///< Aw of each cutter, m2; empty: none. Only where it cuts
};

/// Results for one cutter.
struct WarrenSinorCutter {
  double area = 0.0;    ///< m2
  double volume = 0.0;  ///< m3 per revolution
  double arm = 0.0;     ///< m
  CutterForce force;    ///< N, including the flat
};

/// Loads on the bit, constant in its frame. Lateral forces act on the bit in the position in which
/// its X-axis is in the plane.
struct WarrenSinorLoad {
  double advance = 0.0;                                         ///< m per revolution
  double weight = 0.0, torque = 0.0;                            ///< N, N m
  double volume = 0.0;                                          ///< m3 per revolution
  Eigen::Vector2d radial_B = Eigen::Vector2d::Zero();           ///< N, of normal forces
  Eigen::Vector2d circumferential_B = Eigen::Vector2d::Zero();  ///< N, of cutting forces
  std::vector<WarrenSinorCutter> cutters;

  Eigen::Vector2d imbalance_B() const { return radial_B + circumferential_B; }  ///< N
  double imbalance() const { return imbalance_B().norm() / weight; }            ///< over the weight
  /// Rate of penetration, m/s, at a rotary speed (rad/s).
  double rate(double rotary_speed) const { return advance * rotary_speed / (2 * std::numbers::pi); }
};

/// Computes the loads at an advance, m per revolution > 0. Throws InputError without cutters.
WarrenSinorLoad warren_sinor(const std::vector<bit::Cutter>& cutters, double advance,
                             const DragRock& rock, const WarrenSinorOptions& options = {});

/// The same for given outlines, so that many advances of one bit require only the passes. `cut` and
/// `load` keep their arrays from call to call.
void warren_sinor(const std::vector<bit::Cutter>& cutters, const RadialOutlines& outlines,
                  double advance, const DragRock& rock, const WarrenSinorOptions& options,
                  PlanarCut& cut, WarrenSinorLoad& load);

/// Range in which the advance for a weight is searched, m per revolution.
struct AdvanceBracket {
  double least = 1e-9, most = 0.05;
};

/// Finds the advance for a weight, N, by bisection to rounding; the weight does not decrease as the
/// advance grows. Throws InputError if no advance in the bracket gives the weight: wear flats alone
/// may carry more.
WarrenSinorLoad warren_sinor_at_weight(const std::vector<bit::Cutter>& cutters, double weight,
                                       const DragRock& rock, const WarrenSinorOptions& options = {},
                                       const AdvanceBracket& bracket = {});

}  // namespace tdbd::reference
