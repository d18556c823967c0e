#include "calibration/cuts/groove_cut.hpp"

#include <algorithm>
#include <cmath>

#include "forces/laws/virgin_groove.hpp"

namespace tdbd::calibration {
namespace {

/// Length of the rim in the rock: an arc of the face, which is foreshortened in depth.
double engaged_rim(const SingleCutter& c, double depth) {
  const double radius = 0.5 * c.diameter;
  const double in_face = depth / std::cos(c.back_rake);
  return c.diameter * std::acos(std::clamp(1.0 - in_face / radius, -1.0, 1.0));
}

const Vec3 arm(0.0, -1.0, 0.0);  // m

}  // namespace

CutRun groove_cut(const SingleCutter& c, double depth, double ahead_share) {
  const forces::GrooveCutter groove{c.diameter, c.back_rake};
  double cut_area = forces::groove_area(groove, depth);
  if (ahead_share > 0.0) cut_area -= forces::groove_area(groove, ahead_share * depth);
  const double rim = engaged_rim(c, depth);
  simulation::CutOfPart face;
  face.cut.kind = bit::PartKind::face;
  face.cut.diameter = c.diameter;
  face.cut.engaged_edge = rim;
  face.cut.point = arm;
  face.cut.normal = Vec3::UnitZ();
  face.face_area = cut_area / std::cos(c.back_rake);
  face.forward_W = Vec3(std::cos(c.back_rake), 0.0, -std::sin(c.back_rake));
  CutRun run{depth, {face}};
  const double pressed = c.wear_flat + c.chamfer * rim;
  if (!(pressed > 0.0)) return run;
  simulation::CutOfPart flat = face;
  flat.cut.kind = bit::PartKind::chamfer;
  flat.cut.contact_area = pressed;
  flat.face_area = 0.0;
  flat.forward_W.setZero();
  run.cuts.push_back(flat);
  return run;
}

}  // namespace tdbd::calibration
