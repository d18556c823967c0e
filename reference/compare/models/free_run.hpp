#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/compare/models/blanks.hpp"
#include "reference/literature/drag/planes/bit_path.hpp"

/// Shared by models whose bit is on the case's string with a free motion.
namespace tdbd::reference {

/// A bit's motion through the rock over the counted steps.
struct FreeMotion {
  double sunk = 0.0, turned = 0.0;  ///< m, rad: advance and rotation
  double squares = 0.0;             ///< m2, sum of the squared distances from the hole's axis
  double duration = 0.0;            ///< s
  long steps = 0;
};

/// Advance per revolution, m.
double found_advance(const FreeMotion& m);

/// Sets the computed rate of penetration, the whirl and, if the top prescribes a load, the results
/// at a weight. `torque`: N m.
void set_free_motion_quantities(const CompareCase& c, const FreeMotion& m, Findings& f);

/// Pose of an upright bit in the rock, and its velocity: m/s, rad/s.
struct FreeInstant {
  BitPlace place;
  Vec3 v_W = Vec3::Zero();
  double turn_rate = 0.0;
};

/// A running model. Loads are those at the start of the step that `advance` computed.
struct FreeModel {
  std::string title;
  std::function<void()> advance;
  std::function<FreeInstant()> now;
  std::function<double()> hole;                ///< m3, up to a constant
  const std::vector<Vec3>* force_W = nullptr;  ///< N, on each cutter
  const std::vector<double>* area = nullptr;   ///< m2, of each
  const double* torque = nullptr;              ///< N m, on the bit
};

/// Runs the case's duration and sets all results of such a model except the bottom. Throws
/// InputError if the motion diverges.
void run_free_model(const CompareCase& c, const FreeModel& model, Findings& f);

}  // namespace tdbd::reference
