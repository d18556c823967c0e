#pragma once

#include "reference/literature/drag/spokes/langeveld_rock.hpp"

namespace tdbd::reference {

/// Langeveld's bit (thesis: 2.1) led on a path: lateral motion locked or prescribed. SEEN in the
/// thesis: 120 spokes of 500 points. Reconstructed: the forces, by the area of the cutter's rim in the
/// rock of the spoke that its tip crosses. Throws InputError ("Langeveld: ...").
struct LangeveldLayout {
  int spokes = 120, nodes = 500;
  CountedRock counted = CountedRock::all_above;
};

/// A bit that turns and advances evenly from a bottom that fits it: rad/s, m per revolution.
struct LangeveldDrilling {
  double rotary_speed = 0.0, advance = 0.0;
  double revolutions = 3.0;
  double step = 1e-3;  ///< s
  LangeveldLayout layout;
};

PathRun langeveld_steady(const std::vector<bit::Cutter>& cutters, const DragRock& rock,
                         const LangeveldDrilling& drilling);

/// The same on any path through given rock, which it cuts.
PathRun langeveld_path(const std::vector<SpokeCutter>& cutters, const DragRock& rock,
                       LangeveldRock& bottom, const BitPath& path, const PathOptions& options,
                       CountedRock counted = CountedRock::all_above);

}  // namespace tdbd::reference
