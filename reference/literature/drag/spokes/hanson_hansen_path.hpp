#pragma once

#include "reference/literature/drag/spokes/hanson_hansen_law.hpp"
#include "reference/literature/surface/outline_spokes.hpp"

namespace tdbd::reference {

/// Hanson and Hansen's bit (thesis: 2.1) on a prescribed path, with lateral motion locked or
/// prescribed. Stated in the thesis: any number of spokes, several z for one radius in the plane of
/// a spoke. Reconstructed: a cutter removes its rim, a polygon, from the rock of each spoke that
/// its tip crosses, by a boolean in the plane.
struct HansonHansenLayout {
  int spokes = 120;
  double spacing = 0.25e-3;  ///< m, of nodes along the surface
};

/// A bit that rotates and advances uniformly from a bottom that fits it: rad/s, m per revolution.
struct HansonHansenDrilling {
  double rotary_speed = 0.0, advance = 0.0;
  double revolutions = 3.0;
  double step = 1e-3;  ///< s
  HansonHansenLayout layout;
};

/// Makes rock with a bottom that fits the bit at rest, as fitting_rock does, within a wall of the
/// bit's reach and deep enough for `depth` (m) of drilling. `around`: m of rock beyond the bit's
/// reach.
OutlineSpokes fitting_outline_rock(const std::vector<SpokeCutter>& cutters, double depth,
                                   const HansonHansenLayout& layout, double around = 30e-3);

/// Removes a rim from a spoke and returns the cut. A sliver below 1e-12 m2 is not removed.
CrossingCut cut_outline(OutlineSpokes& rock, int spoke, const RimEllipse& rim);

PathRun hanson_hansen_path(const std::vector<SpokeCutter>& cutters, const HansonHansenRock& rock,
                           OutlineSpokes& bottom, const BitPath& path, const PathOptions& options);

/// Throws InputError ("Hanson and Hansen: ...").
PathRun hanson_hansen_steady(const std::vector<bit::Cutter>& cutters, const HansonHansenRock& rock,
                             const HansonHansenDrilling& drilling);

}  // namespace tdbd::reference
