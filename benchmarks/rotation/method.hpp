#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/rotation/cases.hpp"

namespace tdbd::bench {

/// An integration of one case by one method.
class Integration {
 public:
  Integration() = default;
  Integration(const Integration&) = delete;
  Integration& operator=(const Integration&) = delete;
  virtual ~Integration() = default;

  /// Makes this number of steps, if necessary past the end: for timing.
  virtual void take(long steps) = 0;
  /// From the start to the case's end.
  virtual void run_to_end() = 0;
  virtual dynamics::RotationState state() const = 0;
  virtual long steps() const = 0;
  virtual long torque_evaluations() const = 0;
};

/// What controls the accuracy of a method.
enum class Control {
  step,      ///< a fixed step, s
  tolerance  ///< of the error estimated by the method
};

/// A method to integrate a case. `start` does all expensive preparations once. `setting`: the step
/// or the tolerance.
struct Method {
  std::string name;
  Control control = Control::step;
  std::function<std::unique_ptr<Integration>(const RotationCase&, double setting)> start;
};

/// A program with its methods. `absent`: the reason why it has none.
struct Contender {
  std::string name;
  std::string absent;
  std::vector<Method> methods;
};

/// Every drift of src/dynamics with one torque evaluation per step, and compositions of the
/// default.
Contender tdbd();

/// GSL's rk8pd on attitude quaternion, body momentum and cone angles.
Contender gsl();

/// Simbody: the body on a Ball, the cones on Pins.
Contender simbody();

/// MuJoCo: the body on a ball joint, the cones on hinges.
Contender mujoco();

/// All of them, in this order.
std::vector<Contender> all_contenders();

/// The inertia of a cone as a separate body, about its centre of mass, which is on its axis at the
/// bit's; and the inertia of the body without the cones. Both are physically possible.
Mat3 cone_inertia(const dynamics::Cone& cone);
Mat3 inertia_without_cones(const dynamics::Gyrostat& g);

}  // namespace tdbd::bench
