#pragma once

#include <functional>
#include <vector>

#include "reference/literature/drag/drag_rock.hpp"
#include "reference/literature/drag/spokes/spoke_cutter.hpp"

namespace tdbd::reference {

/// The cut of a cutter in the plane of a spoke that its tip crosses.
struct CrossingCut {
  double area = 0.0;     ///< m2, of rock in its rim
  double moment = 0.0;   ///< m3, integral of r over that area
  double lowered = 0.0;  ///< m2, lost by the spoke's rock; exceeds area if it cannot overhang
  double edge = 0.0;     ///< m, of the rim's lower branch in rock, if the model uses it
  double depth = 0.0;    ///< m, of the tip below the rock, if the model uses it
};

/// Options for a bit on a prescribed path through spokes. The path is linear within a step, so a
/// whirl needs steps well below a spoke's spacing.
struct PathOptions {
  double duration = 0.0;  ///< s
  double step = 1e-3;     ///< s
  double counted = 0.0;   ///< s, at the end, over which means are taken; 0: the last revolution
};

/// Results for a bit on a prescribed path. A cutter that passes a spoke obliquely gets the fraction
/// of its force that corresponds to the area normal to its motion, so that a drag of eps A does the
/// work eps V. Means and `spread` count each crossing for its own duration (SpokeLoad). Loads that
/// are kept from one crossing to the next (`held`) are equal in steady drilling, but too large in a
/// whirl, in which tips that reverse cross no spoke for a long time. `by_step`: a force acts only
/// in the step in which its cutter crosses, with its whole impulse.
struct PathRun {
  std::vector<double> area;       ///< m2, of each cutter, mean over its crossings
  std::vector<double> volume;     ///< m3 per revolution, of each cutter
  std::vector<Vec3> force_B;      ///< N, on each cutter, mean, rotating with the bit
  double wob = 0.0, tob = 0.0;    ///< N, N m: mean
  Vec3 lateral_B = Vec3::Zero();  ///< N, on the bit, rotating with it: mean
  double side = 0.0;              ///< N: mean over steps of the magnitude of the horizontal force
  double lowered = 0.0;           ///< m3 per revolution
  double backwards = 0.0;         ///< fraction of crossings against the rotation
  std::vector<double> wob_spread, tob_spread;                        ///< per step
  std::vector<double> wob_held, tob_held, wob_by_step, tob_by_step;  ///< per step
  long steps = 0, crossings = 0;
};

/// Where on its spoke the force of a cut acts: at the centroid of the area, or at the cutter's tip.
enum class ForceAt { middle_of_area, tip };

/// The functions of a model in a path run: the cut at a crossing, and the force of a cut on the
/// bit.
struct PathModel {
  int spokes = 0;
  /// Cuts the rock and returns the cut.
  std::function<CrossingCut(std::size_t cutter, int spoke, const PlacedCutter& c)> cut;
  /// Force on the bit, W, for a velocity of the tip through the rock, W.
  std::function<Vec3(std::size_t cutter, const CrossingCut& cut, const Vec3& normal_W,
                     const Vec3& face_W, const Vec3& v_W)>
      force;
  ForceAt acts = ForceAt::middle_of_area;
};

/// Uniform drilling requested from a model on spokes.
struct RequestedDrilling {
  double rotary_speed = 0.0, advance = 0.0, revolutions = 0.0, step = 0.0;
  int spokes = 0;
};

/// Throws InputError that begins with the model's name if it cannot be drilled.
void check_drilling(const RequestedDrilling& asked, const std::string& model);

PathRun follow(const BitPath& path, const std::vector<SpokeCutter>& cutters, const PathModel& model,
               const PathOptions& options);

/// Force on a sharp cutter: eps A against the horizontal component of the motion, zeta eps A out of
/// the rock along the profile's normal.
Vec3 area_force(const DragRock& rock, double area, const Vec3& normal_W, const Vec3& v_W);

}  // namespace tdbd::reference
