#pragma once

#include "reference/literature/drag/spokes/spoke_path.hpp"

namespace tdbd::reference {

/// The two kinds of force model of Hanson and Hansen (1995). SEEN in the thesis (2.1): the first is based on tests of
/// single cutters, the second on matching whole bits. Neither's equations were found: `area` is the law that all
/// models of the comparison share (DragRock), `edges` a reconstruction from the thesis's symbols (appendix C: face,
/// chamfer, other contact).
enum class HansonHansenLaw { area, edges };

/// Coefficients of `edges`. A face drags Scc (A1 (1 + A2 tan B) A + A4 te De) and presses tan(B + A3) times that, with
/// A the area in rock, De the length of its edge in rock and B the effective back rake; a chamfer presses A5 Scc Ach
/// and drags A6 times that; other contact, of a cutter that moves with its back ahead, A7 Scc As and A8. B is that of
/// forces (2): the angle between the face's normal and the motion, without a sign, so that side rake counts.
struct EdgeCoefficients {
  double strength = 0.0;                          ///< Scc, Pa
  double A1 = 1.0, A2 = 0.0, A3 = 0.0, A4 = 0.0;  ///< A3: rad
  double te = 1e-4;                               ///< m
  double A5 = 1.0, A6 = 0.6, A7 = 0.5, A8 = 0.3;
  double other_width = 1e-3;  ///< m, As = De times this: our choice
};

struct HansonHansenRock {
  HansonHansenLaw law = HansonHansenLaw::area;
  DragRock shared;
  EdgeCoefficients edges;
};

/// Width of a chamfer's shadow along the profile's normal, m: its face at `chamfer_angle` from the cutter's axis,
/// turned by the back rake. 0 for a sharp edge.
double chamfer_shadow(const SpokeCutter& cutter);

/// Force on a cutter, W, N. Directions unit, W; v_W: of the tip through the rock, m/s.
Vec3 hanson_hansen_force(const HansonHansenRock& rock, const SpokeCutter& cutter,
                         const CrossingCut& cut, const Vec3& normal_W, const Vec3& face_W,
                         const Vec3& v_W);

}  // namespace tdbd::reference
