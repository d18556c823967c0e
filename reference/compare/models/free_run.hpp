#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/compare/models/blanks.hpp"
#include "reference/literature/drag/planes/bit_path.hpp"

/// What models have in common whose bit hangs on the case's string and moves by itself.
namespace tdbd::reference {

/// A bit's motion through the rock over the steps that count.
struct FreeMotion {
  double sunk = 0.0, turned = 0.0;  ///< m, rad
  double squares = 0.0;             ///< m2, sum of its squared distances from the hole's axis
  double duration = 0.0;            ///< s
  long steps = 0;
};

/// m a revolution.
double found_advance(const FreeMotion& m);

/// The rate that it found, its whirl, and what it says of a weight if the top gives one; `torque`: N m.
void say_free_motion(const CompareCase& c, const FreeMotion& m, Findings& f);

/// Where an upright bit is in the rock, and how it moves: m/s, rad/s.
struct FreeInstant {
  BitPlace place;
  Vec3 v_W = Vec3::Zero();
  double turn_rate = 0.0;
};

/// A running model. Loads are those at the start of the step that `advance` made.
struct FreeModel {
  std::string title;
  std::function<void()> advance;
  std::function<FreeInstant()> now;
  std::function<double()> hole;                ///< m3, but for a constant
  const std::vector<Vec3>* force_W = nullptr;  ///< N, on each cutter
  const std::vector<double>* area = nullptr;   ///< m2, of each
  const double* torque = nullptr;              ///< N m, on the bit
};

/// Runs the case's time and says all that such a model says but for the bottom. Throws InputError when the motion
/// diverges.
void drive_and_say(const CompareCase& c, const FreeModel& model, Findings& f);

}  // namespace tdbd::reference
