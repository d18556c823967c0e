#pragma once

#include <array>
#include <vector>

#include "reference/literature/roller/craters/crater_bottom.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"

namespace tdbd::reference {

/// What of a tooth's stay in the rock becomes crater: its deepest place alone, as tables of single-tooth
/// tests know it, or all its way.
enum class PrintPath { deepest, swept };

/// What a tooth feels on its way up: nothing, since crushed rock does not spring back and the law is that of
/// pressing in, or the law at its depth, as "force by depth" taken at its word. Elastic teeth give back the
/// work of pressing in: the bit then drills almost without torque.
enum class ToothRelease { crushed, elastic };

/// How craters are made. All of it is our reconstruction: thesis 2.2 has no word on the bottom's update.
struct PrintOptions {
  PrintPath path = PrintPath::deepest;
  CraterShape shape = CraterShape::cone;
  ToothRelease release = ToothRelease::crushed;
  double release_distance = 20e-6;  ///< m, over which a crushed tooth's force falls to 0
  double sphere_radius = 0.0;  ///< m, of round ends; 0: of the bit's teeth, which must be alike
};

/// One tooth's stay in the rock. Rock under a tooth is not removed before the tooth has left it: its depth
/// is counted from the bottom that it came to.
struct ToothPrint {
  static constexpr int capacity = 48;
  double deepest = 0.0;             ///< m, so far; 0: out of the rock
  Vec3 deepest_tip = Vec3::Zero();  ///< m, in space, where it was
  int first = 0, count = 0;         ///< of the way behind it, a ring
  std::array<Vec3, capacity> way;   ///< m, in space
  std::array<double, capacity> depths;
};

/// Volumes that craters took, m3.
struct PrintVolumes {
  double isolated = 0.0;  ///< each alone in flat rock
  double dug = 0.0;       ///< of the bottom
};

/// Which share of the law's force a tooth at this depth (m) feels; does not fall with depth.
double print_share(const PrintOptions& options, const ToothPrint& print, double depth);

/// After a step: the tooth's point is at `tip_W`, `depth` below the bottom there (negative: above it). Digs
/// what it has left behind and adds to the volumes. Returns the volume dug, m3.
double follow_print(ToothPrint& print, const ToothLaw& law, const PrintOptions& options,
                    const Vec3& tip_W, double depth, ZMap& bottom, PrintVolumes& volumes);

}  // namespace tdbd::reference
