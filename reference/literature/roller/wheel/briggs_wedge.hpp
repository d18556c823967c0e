#pragma once

namespace tdbd::reference {

/// Briggs's rock, thesis 2.2: a Coulomb plastic material. Stated in the thesis: this, and that a
/// two-dimensional sprocket is driven across flat rock for the forces and the torque of a bit. All
/// equations here are reconstructed from plastic limit loads.
struct CoulombRock {
  double cohesion = 0.0;        ///< c, Pa
  double friction_angle = 0.0;  ///< phi, rad; 0: a rock of constant shear strength 2c
};

/// Pressure (Pa) on the smooth flanks of a wedge of this half-angle b (rad, 0 to 90 degrees)
/// without a lip: c cot phi (Kp exp(2b tan phi) - 1), Kp = (1 + sin phi)/(1 - sin phi). From memory
/// of Cheatham's wedge (confidence 0.8). Its limits are known: the unconfined strength at b = 0,
/// Prandtl's flat punch at 90 degrees, 2c (1 + b) without friction.
double wedge_pressure(const CoulombRock& rock, double half_angle);

/// The inverse: cohesion (Pa) of a rock of this friction angle that yields at a pressure.
double wedge_cohesion(double pressure, double friction_angle, double half_angle);

/// A wedge pressed straight into flat rock.
struct WedgeTooth {
  double half_angle = 0.0;  ///< b, rad
  double width = 0.0;       ///< L, m
};

double wedge_load(const WedgeTooth& tooth, double pressure,
                  double depth);  ///< N, 2 p L depth tan b
double wedge_depth(const WedgeTooth& tooth, double pressure, double load);  ///< m, its inverse
double wedge_work(const WedgeTooth& tooth, double pressure, double depth);  ///< J, of the crater

/// A sprocket on rigid rock: it falls from tip to tip. Closed forms.
struct RigidSprocket {
  double rise = 0.0;       ///< m, of the axle above a tip: R (1 - cos(pi/n))
  double pitch = 0.0;      ///< m, from tip to tip: 2R sin(pi/n)
  double most_drag = 0.0;  ///< largest ratio of pull to load: tan(pi/n)
  double mean_drag = 0.0;  ///< mean ratio if each fall's energy is lost: tan(pi/(2n))/2
};
RigidSprocket rigid_sprocket(double radius, int teeth);

/// Ratio of pull to load of a smooth wheel that rolls in plastic rock: rolling resistance. The
/// pressure of the rock is uniform along the arc before the lowest point, so the pull is p L delta
/// and the load p L sqrt(2R delta - delta^2). The ratio is sqrt(delta/(2R)) for small delta.
double smooth_wheel_drag(double radius, double penetration);

}  // namespace tdbd::reference
