#pragma once

#include <array>
#include <vector>

#include "reference/literature/roller/craters/crater_bottom.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"

namespace tdbd::reference {

/// Which part of a tooth's path in the rock becomes a crater: its deepest place alone, as in tables
/// of single-tooth tests, or its whole path.
enum class PrintPath { deepest, swept };

/// The force on a tooth on its way up. `crushed`: none, because crushed rock does not spring back
/// and the law is that of pressing in. `elastic`: the law at its depth, a literal reading of "force
/// by depth". Elastic teeth return the work of pressing in, so the bit drills almost without
/// torque.
enum class ToothRelease { crushed, elastic };

/// How craters are made. All of it is our reconstruction: thesis 2.2 does not describe the update
/// of the bottom.
struct PrintOptions {
  PrintPath path = PrintPath::deepest;
  CraterShape shape = CraterShape::cone;
  ToothRelease release = ToothRelease::crushed;
  double release_distance = 20e-6;  ///< m, over which a crushed tooth's force decreases to 0
  double sphere_radius = 0.0;       ///< m, of round ends; 0: of the teeth, which must be equal
};

/// One contact of a tooth with rock. Rock under a tooth is removed only after the tooth has left
/// it; its depth is measured from the bottom at first contact.
struct ToothPrint {
  static constexpr int capacity = 48;
  double deepest = 0.0;             ///< m, largest depth so far; 0: out of the rock
  Vec3 deepest_tip = Vec3::Zero();  ///< m, in space, place of the largest depth
  int first = 0, count = 0;         ///< of the path behind it, a ring buffer
  std::array<Vec3, capacity> way;   ///< m, in space
  std::array<double, capacity> depths;
};

/// Volumes of craters, m3.
struct PrintVolumes {
  double isolated = 0.0;  ///< sum of the craters as if each were isolated in flat rock
  double dug = 0.0;       ///< removed from the bottom
};

/// The share of the law's force on a tooth at this depth (m). Does not decrease with depth.
double print_share(const PrintOptions& options, const ToothPrint& print, double depth);

/// Update after a step: the tooth's tip is at `tip_W`, `depth` below the bottom there (negative:
/// above it). Digs the craters that it has left and adds to the volumes. Returns the dug volume,
/// m3.
double follow_print(ToothPrint& print, const ToothLaw& law, const PrintOptions& options,
                    const Vec3& tip_W, double depth, ZMap& bottom, PrintVolumes& volumes);

}  // namespace tdbd::reference
