#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/rotation/cases.hpp"

namespace tdbd::bench {

/// One case under way by one method.
class Integration {
 public:
  Integration() = default;
  Integration(const Integration&) = delete;
  Integration& operator=(const Integration&) = delete;
  virtual ~Integration() = default;

  /// So many steps, past the end if need be: for timing.
  virtual void take(long steps) = 0;
  /// From the start to the case's end.
  virtual void run_to_end() = 0;
  virtual dynamics::RotationState state() const = 0;
  virtual long steps() const = 0;
  virtual long torque_evaluations() const = 0;
};

/// What makes a method more accurate.
enum class Control {
  step,      ///< a fixed step, s
  tolerance  ///< of the error that it estimates
};

/// A way to integrate a case. `start` builds everything that costs time once; `setting` is the step
/// or the tolerance.
struct Method {
  std::string name;
  Control control = Control::step;
  std::function<std::unique_ptr<Integration>(const RotationCase&, double setting)> start;
};

/// A program with its methods. `absent` says why there are none.
struct Contender {
  std::string name;
  std::string absent;
  std::vector<Method> methods;
};

/// Every drift of src/dynamics at one torque evaluation a step, and compositions of the default.
Contender tdbd();

/// GSL's rk8pd on attitude quaternion, body momentum and cone angles.
Contender gsl();

/// Simbody: the body on a Ball, the cones on Pins.
Contender simbody();

/// MuJoCo: the body on a ball joint, the cones on hinges.
Contender mujoco();

/// All of them, in this order.
std::vector<Contender> all_contenders();

/// The inertia of a cone as a body of its own, about its centre of mass, which is on its axis where
/// the bit's is; and what the body has without them. Every share is one that a body can have.
Mat3 cone_inertia(const dynamics::Cone& cone);
Mat3 inertia_without_cones(const dynamics::Gyrostat& g);

}  // namespace tdbd::bench
