#pragma once

#include "reference/literature/drag/spokes/hanson_hansen.hpp"
#include "reference/literature/drag/spokes/hanson_hansen_teeth.hpp"

namespace tdbd::reference {

/// A roller cone bit of Hanson and Hansen's program (thesis: 2.2). SEEN: one degree of freedom for each cone,
/// independent of all others; integration by a standard Runge-Kutta method; teeth are spheres. So a cone's equation
/// is Ic phi'' = s . sum (p - o) x F, without the bit's own acceleration. Reconstructed: the force, and that a tooth
/// presses from the rock that it met when it came. The cones' shells, surfaces of revolution, touch nothing here.
struct HansonHansenCones {
  DrillStringAndRock system;
  ToothRock rock;
  RollerBit bit;
  bool lateral_locked = true;
  double step = 1e-4;  ///< s
  std::vector<SphereTooth> teeth;
  OutlineSpokes bottom;
  double start_depth = 0.0;  ///< m, z of the flat rock under the bit at z = 0
  std::vector<SpokePlane> planes;
  HansonHansenState state{};
  double time = 0.0;  ///< s
  std::vector<double> met,
      deepest;                      ///< of each tooth: z of the rock it met, NAN without contact; m
  HansonHansenLoad load;            ///< at the last step's start
  std::vector<Vec3> tooth_force_W;  ///< N, there
  double removed = 0.0;             ///< m3, so far
  std::vector<double> tooth_removed;  ///< m3, by each tooth
  std::vector<Vec3> cut_at_W;         ///< m: where each tooth was last taken out of the rock
  double cut_after = 0.1e-3;          ///< m, of a tooth's way between two cuts of its crater
};

struct ConesSetup {
  DrillStringAndRock system;
  ToothRock rock;
  HansonHansenLayout layout{120, 1e-3};
  bool lateral_locked = true;
  double step = 1e-4, depth = 0.05;  ///< s; m of rock to drill
  double cone_ratio = 1.6;           ///< of cone to bit speed at the start, against each other
};

/// A bit whose lowest tooth touches flat rock. Throws InputError ("Hanson and Hansen: ...").
HansonHansenCones hanson_hansen_cones(const RollerBit& bit, const ConesSetup& setup);

/// One step.
void advance(HansonHansenCones& model);

HansonHansenLoad cones_load(const HansonHansenCones& model, const HansonHansenState& y,
                            std::vector<Vec3>* force_W = nullptr);

/// Teeth that press now.
int teeth_in_contact(const HansonHansenCones& model);

/// What the model leaves out: a cone's share of its bit's angular acceleration, rad/s2.
double neglected_acceleration(const RollerCone& cone, double bit_acceleration);

/// The deepest surface of a spoke's rock at a radius (z, m); minus infinity where there is none.
double surface_depth(const OutlineSpokes& rock, int spoke, double r);

}  // namespace tdbd::reference
