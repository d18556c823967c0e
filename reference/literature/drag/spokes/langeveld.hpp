#pragma once

#include <array>

#include "reference/literature/drag/spokes/langeveld_path.hpp"
#include "reference/literature/drag/spokes/spoke_crossings.hpp"

namespace tdbd::reference {

/// Langeveld's bit dynamics (1992; thesis: 2.1). Stated in the thesis: 120 spokes of 500 points; a
/// full circle as gage, without junk slots; translations x, y, z and rotation about z; classical
/// Runge-Kutta; a string of mass and springs; a very simple law of the depth of cut. Reconstructed:
/// that law, the cutters and the wall.
///
///   M x'' + Kxy x = Fx,  M y'' + Kxy y = Fy,  M z'' + c z' + Kz (z - V t) = Fz,
///   I th'' + Kth (th - Omega t) = Tz
///
/// The viscous damping c is an addition; c = 0 gives Langeveld's string. The rock is constant
/// during a step; the spokes that the step's motion crosses are cut after it. So the coupled motion
/// is of first order in the step.
enum class LateralMotion { locked, free };

struct LangeveldSystem {
  double mass = 1000.0, inertia = 100.0;  ///< M, kg; I, kg m2
  double lateral_stiffness = 0.0, axial_stiffness = 7e5, twist_stiffness = 938.0;  ///< N/m, N m/rad
  double axial_damping = 0.0;                                                      ///< c, N s/m
  double rate = 0.0, speed = 0.0;       ///< of the string's top: V, m/s; Omega, rad/s
  double top_z = 0.0, top_angle = 0.0;  ///< position at t = 0: m, rad
  WallSpring wall;
  LateralMotion lateral = LateralMotion::free;
  LangeveldLaw law = LangeveldLaw::outline;
  CountedRock counted = CountedRock::all_above;
  DragRock rock;
  std::vector<double> widths;  ///< m, of each cutter, for LangeveldLaw::tip
  double step = 1e-3;          ///< s
};

/// x, y, z of the bit's origin (m, W), rotation (rad), and their rates.
using LangeveldState = std::array<double, 8>;

/// Loads of rock and wall on the bit, N, and N m about its axis; and on each cutter.
struct LangeveldLoad {
  Vec3 force_W = Vec3::Zero();
  double torque = 0.0;
  std::vector<Vec3> cutter_force_W;  ///< N
  std::vector<double> cutter_area;   ///< m2, as used by the force law
};

/// A running model, including all reused buffers.
struct Langeveld {
  LangeveldSystem system;
  std::vector<SpokeCutter> cutters;
  double gage = 0.0;  ///< Rb, m: largest reach of a rim
  LangeveldRock rock;
  LangeveldState state{};
  double time = 0.0;  ///< s
  SpokeTracker tracker;
  LangeveldLoad load;   ///< at the start of the last step
  LangeveldLoad stage;  ///< of the other stages of the method
};

/// Throws InputError ("Langeveld: ...").
Langeveld langeveld(const std::vector<bit::Cutter>& cutters, const LangeveldSystem& system,
                    LangeveldRock rock, const LangeveldState& start);

/// Makes one step.
void advance(Langeveld& model);

/// Load of rock and wall on the bit in a state, with the present rock. Reuses the arrays of the
/// load.
void langeveld_load(const Langeveld& model, const LangeveldState& state, LangeveldLoad& load);

}  // namespace tdbd::reference
