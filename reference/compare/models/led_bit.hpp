#pragma once

#include "reference/compare/model.hpp"
#include "reference/literature/drag/planes/bit_path.hpp"
#include "reference/literature/drag/spokes/spoke_path.hpp"

/// Shared by models whose bit is moved along the case's path through spokes.
namespace tdbd::reference {

/// The path of the case's motion.
BitPath path_of(const CompareCase& c);

/// Radius that spokes must reach, m: that of the bit plus that of its whirl, plus a margin.
double spoke_reach(const CompareCase& c);

/// The first kind of force model of Hanson and Hansen with the shared law, the second with its own
/// law.
HansonHansenRock hanson_hansen_rock(const CompareCase& c);

/// Results for one cutter, in the order of the case's cutters.
struct CutterNumbers {
  double area = 0.0, volume = 0.0, normal = 0.0, drag = 0.0;
};

/// Components of a force on a cutter in the bit's frame, N: out of the rock along its profile's
/// normal, and against its direction of motion.
CutterNumbers forces_of(const bit::Cutter& cutter, const Vec3& force_B);

void set_cutter_quantities(const CompareCase& c, const std::vector<CutterNumbers>& cutters,
                           Findings& f);

/// Sets the imbalance from the mean lateral force in the bit's frame, and the side force from the
/// mean of its magnitude over the steps, N.
void set_lateral_quantities(const Eigen::Vector2d& mean_B, double side, Findings& f);

/// The last `count` values.
std::vector<double> last_of(const std::vector<double>& values, long count);

/// Sets all results of a run on a prescribed path: loads, noise, cutters, removed rock, number of
/// steps.
void set_path_run_quantities(const CompareCase& c, const PathRun& run, Findings& f);

}  // namespace tdbd::reference
