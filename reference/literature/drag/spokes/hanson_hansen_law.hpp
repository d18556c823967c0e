#pragma once

#include "reference/literature/drag/spokes/spoke_path.hpp"

namespace tdbd::reference {

/// The two kinds of force model of Hanson and Hansen (1995). Stated in the thesis (2.1): the first
/// is based on tests of single cutters, the second on matching whole bits. The equations of neither
/// were found. `area` is the law that all models of the comparison share (DragRock); `edges` is a
/// reconstruction from the thesis's symbols (appendix C: face, chamfer, other contact).
enum class HansonHansenLaw { area, edges };

/// Coefficients of `edges`. The drag of a face is Scc (A1 (1 + A2 tan B) A + A4 te De) and its
/// normal force tan(B + A3) times that, with A the area in rock, De the length of its edge in rock
/// and B the effective back rake. The normal force of a chamfer is A5 Scc Ach and its drag A6 times
/// that. Other contact, of a cutter that moves with its back ahead, has the normal force A7 Scc As
/// and the drag A8 times that. B is that of forces (2): the unsigned angle between the face's
/// normal and the motion, which includes side rake.
struct EdgeCoefficients {
  double strength = 0.0;                          ///< Scc, Pa
  double A1 = 1.0, A2 = 0.0, A3 = 0.0, A4 = 0.0;  ///< A3: rad
  double te = 1e-4;                               ///< m
  double A5 = 1.0, A6 = 0.6, A7 = 0.5, A8 = 0.3;
  double other_width = 1e-3;  ///< m; As = De times this (our choice)
};

struct HansonHansenRock {
  HansonHansenLaw law = HansonHansenLaw::area;
  DragRock shared;
  EdgeCoefficients edges;
};

/// Width of a chamfer's projection along the profile's normal, m: its face at `chamfer_angle` from
/// the cutter's axis, rotated by the back rake. 0 for a sharp edge.
double chamfer_shadow(const SpokeCutter& cutter);

/// Force on a cutter, W, N. Directions are unit vectors, W. v_W: velocity of the tip through the
/// rock, m/s.
Vec3 hanson_hansen_force(const HansonHansenRock& rock, const SpokeCutter& cutter,
                         const CrossingCut& cut, const Vec3& normal_W, const Vec3& face_W,
                         const Vec3& v_W);

}  // namespace tdbd::reference
