#pragma once

#include "reference/literature/drag/spokes/hanson_hansen.hpp"

namespace tdbd::reference {

/// A PDC bit that moves by equations (2.1) to (2.3) over spokes with several z. The rock is
/// constant during a step of the classical Runge-Kutta method (stated in the thesis, 2.2); the
/// spokes that the step's motion crosses are cut after it.
struct HansonHansenPdc {
  DrillStringAndRock system;
  HansonHansenRock rock;
  WallSpring spring;
  bool lateral_locked = false;
  double step = 1e-3;  ///< s
  std::vector<SpokeCutter> cutters;
  double gage = 0.0;  ///< m
  OutlineSpokes bottom;
  SpokeWall wall;
  HansonHansenState state{};
  double time = 0.0;  ///< s
  SpokeTracker tracker;
  HansonHansenLoad load;             ///< at the start of the last step
  std::vector<Vec3> cutter_force_W;  ///< N, at the start of the last step
  std::vector<double> cutter_area;   ///< m2, at the start of the last step
};

/// Setup of a model. The bottom is that of fitting_outline_rock for `depth` (m) of drilling.
struct HansonHansenSetup {
  DrillStringAndRock system;
  HansonHansenRock rock;
  WallSpring spring;
  HansonHansenLayout layout;
  bool lateral_locked = false;
  double step = 1e-3, depth = 0.1;
  double led =
      0.0;  ///< revolutions of prescribed uniform motion first; one makes the bottom steady
  double weight = 0.0,
         torque = 0.0;  ///< N, N m: initial loads of the string's springs when the bit becomes free
};

/// Makes a bit that becomes free while it rotates and advances with its string's top. Throws
/// InputError ("Hanson and Hansen: ...").
HansonHansenPdc hanson_hansen_pdc(const std::vector<bit::Cutter>& cutters,
                                  const HansonHansenSetup& setup);

/// Makes one step.
void advance(HansonHansenPdc& model);

/// The load in a state, with the present rock. Stores forces and areas of the cutters if the last
/// two arguments are given.
HansonHansenLoad pdc_load(const HansonHansenPdc& model, const HansonHansenState& y,
                          std::vector<Vec3>* force_W = nullptr,
                          std::vector<double>* area = nullptr);

}  // namespace tdbd::reference
