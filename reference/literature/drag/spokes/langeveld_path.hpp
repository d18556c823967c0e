#pragma once

#include "reference/literature/drag/spokes/langeveld_rock.hpp"

namespace tdbd::reference {

/// Langeveld's very simple law of the depth of cut (thesis: 2.1), reconstructed in two ways.
enum class LangeveldLaw {
  tip,     ///< width times depth of the tip in the spoke's rock; acts at the tip
  outline  ///< area of the rim in the spoke's rock; acts at its centroid
};

/// Contact of the cutters of a bit on a prescribed path with a spoke.
struct LangeveldContact {
  CountedRock counted = CountedRock::all_above;
  LangeveldLaw law = LangeveldLaw::outline;
  std::vector<double> widths = {};  ///< m, of each cutter, for LangeveldLaw::tip
};

/// Widths that divide the radius between the tips: from half way to the next smaller radius of a
/// tip to half way to the next larger one. Cutters at one radius have the same width and share the
/// depth.
std::vector<double> tip_widths(const std::vector<SpokeCutter>& cutters);

/// Throws InputError unless each cutter has a width.
void require_widths(std::size_t found, std::size_t cutters);

/// Depth of a tip (z, m) below the rock at a radius of a spoke, extrapolated linearly from the last
/// two nodes that are not beyond the tip, because the next node may be in the wall. Beyond the end
/// of the spoke nothing is known and nothing is cut.
double tip_depth(const LangeveldRock& rock, int spoke, double radius, double z);

/// Langeveld's bit (thesis: 2.1) on a prescribed path, with lateral motion locked or prescribed.
/// Stated in the thesis: 120 spokes of 500 points. Reconstructed: the forces, which are those at
/// the spoke that the cutter's tip crosses. Throws InputError ("Langeveld: ...").
struct LangeveldLayout {
  int spokes = 120, nodes = 500;
  CountedRock counted = CountedRock::all_above;
};

/// A bit that rotates and advances uniformly from a bottom that fits it: rad/s, m per revolution.
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
                       const LangeveldContact& contact = {});

}  // namespace tdbd::reference
