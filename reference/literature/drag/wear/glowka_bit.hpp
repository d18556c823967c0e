#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "core/types.hpp"
#include "reference/literature/drag/plane/worn_outlines.hpp"
#include "reference/literature/drag/wear/glowka_cutter.hpp"
#include "reference/literature/drag/wear/glowka_wear.hpp"

namespace tdbd::reference {

/// Glowka's model of a whole drag bit (SAND86-1745; JPT, August 1989), thesis 2.1: forces from
/// tests of single cutters for the area that each cuts where others cut before it, wear, weight,
/// torque, side force and bending moments; no dynamics. Known: this much, from the thesis, and
/// thermal wear, from the abstract of SPE 14222. Areas are those of the planar model
/// (worn_outlines.hpp); for the rest see glowka_cutter.hpp and glowka_wear.hpp. Side rake is
/// ignored. Frame B: origin at the nose tip, z down, the bit turns about +z.
struct GlowkaBit {
  std::vector<bit::Cutter> cutters;
  WornOutlines outlines;
};

/// `column`: m, of radius. Throws InputError as worn_outlines does.
GlowkaBit glowka_bit(const std::vector<bit::Cutter>& cutters, double column = 0.02e-3);

GlowkaFace glowka_face(const bit::Cutter& cutter);

/// Operating conditions of the bit.
struct GlowkaRun {
  double advance = 0.0;       ///< m per revolution
  double rotary_speed = 0.0;  ///< rad/s
};

/// Results for one cutter in steady drilling.
struct GlowkaCutterLoad {
  double area = 0.0;    ///< m2, cut in the half-plane
  double volume = 0.0;  ///< m3 per revolution
  double depth = 0.0;   ///< m, effective
  GlowkaForces forces;
  double flat_area = 0.0;        ///< m2
  double flat_stress = 0.0;      ///< Pa
  double temperature = 0.0;      ///< K, of the flat; that of the fluid without a flat
  Vec3 force_B = Vec3::Zero();   ///< N, of the rock on the cutter
  Vec3 moment_B = Vec3::Zero();  ///< N m, about B's origin: x and y bend, -z is the torque
};

/// All cutters, and their sums.
struct GlowkaLoads {
  std::vector<GlowkaCutterLoad> cutters;
  double weight = 0.0;               ///< WOB, N
  double torque = 0.0;               ///< TOB, N m
  Vec3 force_B = Vec3::Zero();       ///< N: x and y are the side force, -z the weight
  Vec3 moment_B = Vec3::Zero();      ///< N m: x and y are the bending moments of the face
  WornCut cut;                       ///< what was removed, and the bottom
  std::vector<double> along_normal;  ///< m, wear of every cutter along its profile's normal
};

/// Computes the loads of a bit whose cutters lost `worn` (m, on their faces: y of glowka_wear.hpp).
/// The sharp part of a force acts at the centroid of the cut, that of the flat at the tip. Reuses
/// the arrays of `loads`. Throws InputError for no advance or speed, wear for another number of
/// cutters, or a worn cutter without back rake.
void glowka_loads(const GlowkaBit& bit, const GlowkaLaw& law, const FlatHeat& heat,
                  const std::vector<double>& worn, const GlowkaRun& run, GlowkaLoads& loads);

/// Returns the advance (m per revolution) at which the bit carries this weight (N), and its loads
/// there. Throws InputError as glowka_loads does, or if no advance up to 0.1 m carries it.
double glowka_under_weight(const GlowkaBit& bit, const GlowkaLaw& law, const FlatHeat& heat,
                           const std::vector<double>& worn, double weight, double rotary_speed,
                           GlowkaLoads& loads);

}  // namespace tdbd::reference
