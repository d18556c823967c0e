#pragma once

#include <functional>
#include <vector>

#include "reference/literature/drag/drag_rock.hpp"
#include "reference/literature/drag/spokes/spoke_cutter.hpp"

namespace tdbd::reference {

/// What a cutter finds in the plane of a spoke that its tip crosses.
struct CrossingCut {
  double area = 0.0;     ///< m2, of rock in its rim
  double moment = 0.0;   ///< m3, integral of r over that area
  double lowered = 0.0;  ///< m2, by which the spoke's rock shrinks; more than the area if the
                         ///< surface cannot hang over
  double edge = 0.0;     ///< m, of the rim's lower branch in rock, where the model needs it
  double depth = 0.0;    ///< m, of the tip below the rock, where the model needs it
};

/// How a bit is led through its spokes. The path is followed straight between the ends of a step,
/// so a whirl needs steps well below a spoke's spacing.
struct PathOptions {
  double duration = 0.0;  ///< s
  double step = 1e-3;     ///< s
  double counted = 0.0;   ///< s, at the end, over which means are taken; 0: the last revolution
};

/// A led bit. A cutter that goes askew through a spoke feels the part of its force that the area normal to its motion
/// has, so that a drag of eps A does the work eps V. Means and `spread` count each crossing for its own time
/// (SpokeLoad). Loads held from one crossing to the next (`held`) are the same in steady drilling, and overstate a
/// whirl, in which tips that turn round cross no spoke for long. `by_step`: a force acts only in the step in which its
/// cutter crosses, as strong as its impulse asks.
struct PathRun {
  std::vector<double> area;       ///< m2, of each cutter, mean over its crossings
  std::vector<double> volume;     ///< m3 per revolution, of each cutter
  std::vector<Vec3> force_B;      ///< N, on each cutter, mean, turning with the bit
  double wob = 0.0, tob = 0.0;    ///< N, N m: mean
  Vec3 lateral_B = Vec3::Zero();  ///< N, on the bit, turning with it: mean
  double side = 0.0;              ///< N: mean over steps of the size of the level force
  double lowered = 0.0;           ///< m3 per revolution
  double backwards = 0.0;         ///< share of crossings against the rotation
  std::vector<double> wob_spread, tob_spread;                        ///< of each step
  std::vector<double> wob_held, tob_held, wob_by_step, tob_by_step;  ///< of each step
  long steps = 0, crossings = 0;
};

/// Where on its spoke the force of a cut acts: at the middle of the area, or at the cutter's tip.
enum class ForceAt { middle_of_area, tip };

/// What a path run asks of a model: the rock's cut at a crossing, and the force of a cut on the bit.
struct PathModel {
  int spokes = 0;
  /// Cuts and reports.
  std::function<CrossingCut(std::size_t cutter, int spoke, const PlacedCutter& c)> cut;
  /// Force on the bit, W, for a velocity of the tip through the rock, W.
  std::function<Vec3(std::size_t cutter, const CrossingCut& cut, const Vec3& normal_W,
                     const Vec3& face_W, const Vec3& v_W)>
      force;
  ForceAt acts = ForceAt::middle_of_area;
};

/// Even drilling that a model on spokes is asked for.
struct AskedDrilling {
  double rotary_speed = 0.0, advance = 0.0, revolutions = 0.0, step = 0.0;
  int spokes = 0;
};

/// Throws InputError, which begins with the model's name, for what cannot be drilled.
void check_drilling(const AskedDrilling& asked, const std::string& model);

PathRun follow(const BitPath& path, const std::vector<SpokeCutter>& cutters, const PathModel& model,
               const PathOptions& options);

/// A sharp cutter's force: eps A against the level part of the motion, zeta eps A out of the rock along the
/// profile's normal.
Vec3 area_force(const DragRock& rock, double area, const Vec3& normal_W, const Vec3& v_W);

}  // namespace tdbd::reference
