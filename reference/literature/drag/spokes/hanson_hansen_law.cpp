#include "reference/literature/drag/spokes/hanson_hansen_law.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {
namespace {

/// Tangential and normal loads, N.
struct EdgeLoads {
  double tangential = 0.0, normal = 0.0;
};

EdgeLoads face_and_chamfer(const EdgeCoefficients& c, const SpokeCutter& cutter,
                           const CrossingCut& cut, double rake) {
  const double B1 = c.A1 * (1.0 + c.A2 * std::tan(rake)), B2 = std::tan(rake + c.A3);
  const double face = c.strength * (B1 * cut.area + c.A4 * c.te * cut.edge);
  const double chamfer = c.A5 * c.strength * cut.edge * chamfer_shadow(cutter);
  return {face + c.A6 * chamfer, B2 * face + chamfer};
}

EdgeLoads other_contact(const EdgeCoefficients& c, const CrossingCut& cut) {
  const double normal = c.A7 * c.strength * cut.edge * c.other_width;
  return {c.A8 * normal, normal};
}

/// Components along E1, the motion, and E2, perpendicular to it on the side of the profile's
/// normal.
Vec3 edges_force(const EdgeCoefficients& c, const SpokeCutter& cutter, const CrossingCut& cut,
                 const Vec3& normal_W, const Vec3& face_W, const Vec3& v_W) {
  const double speed = v_W.norm();
  if (cut.area <= 0.0 || speed == 0.0) return Vec3::Zero();
  const Vec3 E1 = v_W / speed, across = normal_W - normal_W.dot(E1) * E1;
  const double size = across.norm();
  const Vec3 E2 = size > 0.0 ? Vec3(across / size) : Vec3::Zero();
  const double ahead = face_W.dot(E1);
  const EdgeLoads loads = ahead > 0.0
                              ? face_and_chamfer(c, cutter, cut, std::acos(std::min(ahead, 1.0)))
                              : other_contact(c, cut);
  return -loads.tangential * E1 - loads.normal * E2;
}

}  // namespace

double chamfer_shadow(const SpokeCutter& cutter) {
  if (cutter.chamfer == 0.0) return 0.0;
  const double length = cutter.chamfer / std::tan(cutter.chamfer_angle);
  return length * std::cos(cutter.back_rake) + cutter.chamfer * std::sin(cutter.back_rake);
}

Vec3 hanson_hansen_force(const HansonHansenRock& rock, const SpokeCutter& cutter,
                         const CrossingCut& cut, const Vec3& normal_W, const Vec3& face_W,
                         const Vec3& v_W) {
  return rock.law == HansonHansenLaw::area
             ? area_force(rock.shared, cut.area, normal_W, v_W)
             : edges_force(rock.edges, cutter, cut, normal_W, face_W, v_W);
}

}  // namespace tdbd::reference
