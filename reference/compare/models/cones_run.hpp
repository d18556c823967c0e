#pragma once

#include "reference/compare/models/tooth_parts.hpp"
#include "reference/literature/drag/spokes/hanson_hansen_cones.hpp"

/// A run of Hanson and Hansen's roller cone bit, under a weight or on a string, and what it finds in the steps that
/// count.
namespace tdbd::reference {

/// Rock and cones of the case; string, step, rock to drill and the start are left to the caller.
ConesSetup cones_setup(const CompareCase& c, const RollerBit& bit);

/// Steps of the run; those that count are at its end.
struct ConesCount {
  long before = 0, counted = 0;
};

/// Sums over the steps that count.
struct ConesSums {
  LoadSeries series;
  Eigen::Vector2d lateral_B = Eigen::Vector2d::Zero();  ///< N
  double side = 0.0;                                    ///< N
  double squares = 0.0;          ///< m2, of the bit's distances from the hole's axis
  std::vector<double> contacts;  ///< of each step
  ToothNumbers teeth;            ///< sums over the steps
};

/// The model at the first step that counts, and what it did until the last.
struct ConesRun {
  HansonHansenState from;
  std::vector<double> removed;  ///< m3, by each tooth from there on
  ConesSums sums;
};

/// Throws InputError ("Hanson and Hansen: ...") when the motion diverges or the bit leaves its rock.
ConesRun run_cones(HansonHansenCones& m, const ConesCount& n);

/// Teeth, rows, cones, lateral forces over `weight` (N), the bottom, and the cost; not weight, torque, noise and rate.
/// Volumes are those of `turns` of the bit.
void say_cones_run(const CompareCase& c, const HansonHansenCones& m, const ConesRun& run,
                   double weight, double turns, Findings& f);

}  // namespace tdbd::reference
