#pragma once

#include "reference/literature/drag/spokes/hanson_hansen.hpp"
#include "reference/literature/drag/spokes/hanson_hansen_teeth.hpp"

namespace tdbd::reference {

/// A roller cone bit of Hanson and Hansen's program (thesis: 2.2). Stated there: one degree of
/// freedom per cone, independent of all others; integration by a standard Runge-Kutta method; teeth
/// are spheres. So the equation of a cone is Ic phi'' = s . sum (p - o) x F, without the
/// acceleration of the bit. Reconstructed: the force, and that the penetration of a tooth is
/// measured from the rock that it met at the beginning of the contact. The cones' shells, surfaces
/// of revolution, do not touch anything here.
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
      deepest;                        ///< m, per tooth: z of rock met (NAN: none); largest depth
  HansonHansenLoad load;              ///< at the start of the last step
  std::vector<Vec3> tooth_force_W;    ///< N, at the start of the last step
  double removed = 0.0;               ///< m3, total
  std::vector<double> tooth_removed;  ///< m3, by each tooth
  std::vector<Vec3> cut_at_W;         ///< m: where the crater of each tooth was last cut
  double cut_after = 0.1e-3;          ///< m, by which a tooth moves between two cuts of its crater
};

struct ConesSetup {
  DrillStringAndRock system;
  ToothRock rock;
  HansonHansenLayout layout{120, 1e-3};
  bool lateral_locked = true;
  double step = 1e-4, depth = 0.05;  ///< s; m of rock to drill
  double cone_ratio = 1.6;           ///< initial ratio of cone to bit speed, in opposite senses
};

/// Makes a bit whose lowest tooth touches flat rock. Throws InputError ("Hanson and Hansen: ...").
HansonHansenCones hanson_hansen_cones(const RollerBit& bit, const ConesSetup& setup);

/// Makes one step.
void advance(HansonHansenCones& model);

HansonHansenLoad cones_load(const HansonHansenCones& model, const HansonHansenState& y,
                            std::vector<Vec3>* force_W = nullptr);

/// Number of teeth that press now.
int teeth_in_contact(const HansonHansenCones& model);

/// The term that the model omits: a cone's share of its bit's angular acceleration, rad/s2.
double neglected_acceleration(const RollerCone& cone, double bit_acceleration);

/// The deepest surface of a spoke's rock at a radius (z, m); minus infinity if there is none.
double surface_depth(const OutlineSpokes& rock, int spoke, double r);

}  // namespace tdbd::reference
