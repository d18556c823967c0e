#pragma once

#include "reference/compare/models/tooth_parts.hpp"
#include "reference/literature/drag/spokes/hanson_hansen_cones.hpp"

/// A run of Hanson and Hansen's roller cone bit, under a weight or on a string, and its results
/// over the counted steps.
namespace tdbd::reference {

/// Sets rock and cones from the case. The caller sets string, step, rock to drill and start.
ConesSetup cones_setup(const CompareCase& c, const RollerBit& bit);

/// Number of steps of the run; the counted steps are the last ones.
struct ConesCount {
  long before = 0, counted = 0;
};

/// Sums over the counted steps.
struct ConesSums {
  LoadSeries series;
  Eigen::Vector2d lateral_B = Eigen::Vector2d::Zero();  ///< N
  double side = 0.0;                                    ///< N
  double squares = 0.0;          ///< m2, of the bit's distance from the hole's axis
  std::vector<double> contacts;  ///< per step
  ToothNumbers teeth;            ///< sums over the steps
};

/// The model at the first counted step, and its results from there to the last step.
struct ConesRun {
  HansonHansenState from;
  std::vector<double> removed;  ///< m3, by each tooth, in the counted steps
  ConesSums sums;
};

/// Throws InputError ("Hanson and Hansen: ...") if the motion diverges or the bit leaves its rock.
ConesRun run_cones(HansonHansenCones& m, const ConesCount& n);

/// Sets the results for teeth, rows, cones, lateral forces over `weight` (N), bottom and run time,
/// but not weight, torque, noise and rate. Volumes are those of `turns` revolutions of the bit.
void set_cones_run_quantities(const CompareCase& c, const HansonHansenCones& m, const ConesRun& run,
                              double weight, double turns, Findings& f);

}  // namespace tdbd::reference
