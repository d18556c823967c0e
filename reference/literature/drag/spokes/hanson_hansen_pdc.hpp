#pragma once

#include "reference/literature/drag/spokes/hanson_hansen.hpp"

namespace tdbd::reference {

/// A PDC bit that moves by equations (2.1) to (2.3) over spokes with several z. The rock stands still during a step of
/// the classical Runge-Kutta method (SEEN in the thesis, 2.2); what the step's motion crosses is cut after it.
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
  HansonHansenLoad load;             ///< at the last step's start
  std::vector<Vec3> cutter_force_W;  ///< N, there
  std::vector<double> cutter_area;   ///< m2, there
};

/// What a model is made of. The bottom is that of fitting_outline_rock for `depth` (m) of drilling.
struct HansonHansenSetup {
  DrillStringAndRock system;
  HansonHansenRock rock;
  WallSpring spring;
  HansonHansenLayout layout;
  bool lateral_locked = false;
  double step = 1e-3, depth = 0.1;
  double led =
      0.0;  ///< revolutions on which the bit is led evenly before it is free; one makes the bottom steady
  double weight = 0.0,
         torque = 0.0;  ///< N, N m: what the string's springs carry when it is set free
};

/// A bit that is set free while it turns and advances with its string's top. Throws InputError ("Hanson and Hansen: ...").
HansonHansenPdc hanson_hansen_pdc(const std::vector<bit::Cutter>& cutters,
                                  const HansonHansenSetup& setup);

/// One step.
void advance(HansonHansenPdc& model);

/// The load in a state, the rock as it stands; forces and areas of cutters where the last two are given.
HansonHansenLoad pdc_load(const HansonHansenPdc& model, const HansonHansenState& y,
                          std::vector<Vec3>* force_W = nullptr,
                          std::vector<double>* area = nullptr);

}  // namespace tdbd::reference
