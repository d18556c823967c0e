#pragma once

#include "reference/compare/model.hpp"
#include "reference/literature/drag/planes/bit_path.hpp"
#include "reference/literature/drag/spokes/spoke_path.hpp"

/// What the models have in common whose bit is led on the case's path through spokes.
namespace tdbd::reference {

/// The path of the case's motion.
BitPath path_of(const CompareCase& c);

/// Radius that spokes must reach, m: the bit's own and that of its whirl, and a little more.
double spoke_reach(const CompareCase& c);

/// The first kind of force model of Hanson and Hansen under the shared law, the second under its own.
HansonHansenRock hanson_hansen_rock(const CompareCase& c);

/// Numbers about one cutter, in the order of the case's cutters.
struct CutterNumbers {
  double area = 0.0, volume = 0.0, normal = 0.0, drag = 0.0;
};

/// Of a force on a cutter in the bit's frame, N: the share out of the rock along its profile's
/// normal, and the share against its turning.
CutterNumbers forces_of(const bit::Cutter& cutter, const Vec3& force_B);

void say_cutters(const CompareCase& c, const std::vector<CutterNumbers>& cutters, Findings& f);

/// Mean of the lateral force in the bit's frame, and mean of its size over steps, N.
void say_lateral(const Eigen::Vector2d& mean_B, double side, Findings& f);

/// The last so many values.
std::vector<double> last_of(const std::vector<double>& values, long count);

/// All that a led run says: loads, noise, cutters, what it removed, its cost in steps.
void say_led_run(const CompareCase& c, const PathRun& run, Findings& f);

}  // namespace tdbd::reference
