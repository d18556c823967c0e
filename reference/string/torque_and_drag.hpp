#pragma once

#include <vector>

/// Slow twin of src/string/statics: torque and drag of a soft string by quadrature along the hole.
namespace tdbd::reference {

struct DraggedSection {
  double length = 0.0;  ///< m
  double weight = 0.0;  ///< in mud, N/m
  double radius = 0.0;  ///< of the contact, m
};

/// Inclination and azimuth (rad) at a measured depth (m).
struct DraggedStation {
  double depth = 0.0, inclination = 0.0, azimuth = 0.0;
};

struct DraggedString {
  std::vector<DraggedSection> sections;  ///< from the surface down
  std::vector<DraggedStation> stations;  ///< the first at 0
  double friction = 0.0;
};

/// Speeds of every point of the string, and the load on its lower end.
struct DraggedMotion {
  double rate = 0.0;    ///< downward, m/s
  double speed = 0.0;   ///< rad/s
  double pull = 0.0;    ///< tension at the lower end, N
  double torque = 0.0;  ///< torque at the lower end, N m
};

struct DraggedLoad {
  double tension = 0.0;  ///< N
  double torque = 0.0;   ///< N m
};

/// Loads at a depth (m), by the classical Runge-Kutta method with steps of at most `step` (m), from
/// the lower end up:
///     dT/ds = -w cos(inc) + mu N (rate share),   dQ/ds = -mu N r (speed share),
///     N = |T dt/ds + w (ez - (ez . t) t)|
DraggedLoad dragged_load(const DraggedString& string, const DraggedMotion& motion, double depth,
                         double step);

}  // namespace tdbd::reference
