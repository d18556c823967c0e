#include "verification/rock/cut/round_solids.hpp"

#include <rapidcheck.h>

#include <numbers>

#include "bit/cutter/cutter.hpp"
#include "mesh/measures.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock {
namespace {

RoundSolid any_disc() {
  const Vec3 lean = *rc::gen::element(0.0, 0.3) * *battery::direction();
  const Pose X_across{rotation::exp(lean) * rotation::exp(Vec3(0, 0.5 * std::numbers::pi, 0)),
                      *rc::gen::element(0.0, 0.5) * *battery::point(0.5)};
  const mesh::TriangleMesh mesh_P = battery::placed(
      X_across, battery::cylinder(*battery::number(0.3, 0.5), *battery::number(0.02, 1.0),
                                  *battery::integer(12, 70)));
  return {*mesh::convex_solid(mesh_P), mesh::bounding_box(mesh_P).size().norm()};
}

}  // namespace

bit::Bit cutter_bit(double chamfer, double wear, int rim_segments) {
  bit::Cutter c;
  c.diameter = 0.8;
  c.chamfer = chamfer;
  c.chamfer_angle = 0.25 * std::numbers::pi;
  c.length = 0.5;
  c.table_thickness = 0.1;
  c.wear = wear;
  c.X_BC = {Vec3(1, -1, -1).asDiagonal().toDenseMatrix(), Vec3::Zero()};  // the tip is at -Z
  bit::Bit bit;
  for (bit::Part& p : bit::cutter_parts(c, {.rim_segments = rim_segments})) {
    p.group = 0;
    p.X_BP = Pose{rotation::exp(Vec3(0, 0.2, 0)) * p.X_BP.R, Vec3(0, 0, -0.2)};
    p.update_direction_B = Vec3(0.3, 0, 1).normalized();
    bit.parts.push_back(std::move(p));
  }
  return bit;
}

bit::Bit any_cutter_bit() {
  return cutter_bit(*rc::gen::element(0.0, 0.02, 0.05), *rc::gen::element(0.0, 0.03, 0.1),
                    *rc::gen::element(32, 64));
}

RoundSolid any_round_solid() {
  if (*rc::gen::element(0, 0, 1) == 1) return any_disc();
  const CuttingBit cutting = prepare_cutting_bit(any_cutter_bit());
  const CuttingGroup& g = cutting.groups.front();
  return {g.whole->solid.solid_P, g.box_P.size().norm()};
}

}  // namespace tdbd::rock
