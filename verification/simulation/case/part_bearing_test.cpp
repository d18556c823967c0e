#include <gtest/gtest.h>

#include <cmath>

#include "bit/files/bit_export.hpp"
#include "core/error.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/contact_slopes.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/bit/files/bit_reading.hpp"
#include "verification/simulation/mesh_bit.hpp"

namespace tdbd::simulation::part_bearing_test {

using bit::PartKind;

bit::Part part_of(PartKind kind, mesh::TriangleMesh mesh_P, const Vec3& direction = Vec3::UnitZ()) {
  bit::Part part;
  part.name = "part";
  part.kind = kind;
  part.mesh_P = std::move(mesh_P);
  part.update_direction_B = direction;
  return part;
}

bit::Bit bit_of(const bit::Part& part) {
  bit::Bit bit;
  bit.parts = {part};
  return bit;
}

forces::Strength rock() {
  forces::Strength s;
  s.confined = 80e6;
  return s;
}

ForcePlan plan_of(PartKind kind, const forces::Law& law) {
  ForcePlan plan;
  plan.forces = Forces::on;
  plan.laws[static_cast<std::size_t>(kind)] = law;
  plan.rock.strengths = {rock()};
  return plan;
}

forces::Friction pad_law() { return {.stress = 10e6, .mu = 0.3}; }

const mesh::TriangleMesh block = battery::box({0.07, -0.01, -0.02}, {0.09, 0.01, 0.0});

constexpr double of_slip = 1e-6;  // relative: at the usual speed a law's force lacks 5e-7

TEST(AreaAtDepth, of_a_box_is_its_face_and_of_a_ball_its_circle) {
  const bit::Part box = part_of(PartKind::gage_pad, block);
  EXPECT_NEAR(area_at_depth(box, Vec3::UnitZ(), 1e-3), 4e-4, 1e-16);
  EXPECT_NEAR(area_at_depth(box, Vec3::UnitX(), 1e-3), 4e-4, 1e-16);
  const Vec3 edge_down = Vec3(1.0, 0.0, 1.0).normalized();  // a wedge of a right angle
  EXPECT_NEAR(area_at_depth(box, edge_down, 1e-3), 0.02 * 2e-3, 1e-15);
  bit::Part ball = part_of(PartKind::tooth, battery::sphere(0.006, 5));
  ball.X_BP.p = Vec3(0.0, 0.0, 0.1);
  const double circle = pi * (0.012 - 1e-3) * 1e-3;
  EXPECT_NEAR(area_at_depth(ball, Vec3::UnitZ(), 1e-3), circle, 2e-3 * circle);  // of the mesh
}

/// A flat pad carries all it can from the first touch on; its force does not rise with depth.
TEST(PartBearing, of_a_flat_pad_does_not_rise) {
  const bit::Bit bit = bit_of(part_of(PartKind::gage_pad, block));
  const PartBearing b = bearing_of_parts(bit, plan_of(PartKind::gage_pad, pad_law()), rock());
  EXPECT_NEAR(b.at_touch, 4000.0, of_slip * 4000.0);
  EXPECT_NEAR(b.slope, 0.0, 1.0);
  EXPECT_EQ(b.lateral_slope, 0.0);
}

/// A ball has the slope of the spherical cap that a designed cone's tooth has.
TEST(PartBearing, of_a_ball_rises_like_that_of_a_designed_tooth) {
  const bit::Bit bit = bit_of(part_of(PartKind::tooth, battery::sphere(0.006, 5)));
  const double cap = 80e6 * pi * (0.012 - 1e-3);
  const PartBearing b =
      bearing_of_parts(bit, plan_of(PartKind::tooth, forces::Indentation{}), rock());
  EXPECT_NEAR(b.slope, cap, 0.011 * cap);  // less the first hundredth of a millimetre
  EXPECT_LT(b.at_touch, 0.011 * cap * 1e-3);
}

/// Pads push outwards at their own azimuth: a cylinder's segment in a flat wall.
TEST(PartBearing, of_a_pad_that_faces_outwards_is_lateral) {
  bit::Part pad = part_of(PartKind::gage_pad, battery::cylinder(0.02, 0.05, 720), Vec3::UnitX());
  pad.X_BP.p = Vec3(0.0, 0.1, 0.0);
  const PartBearing b =
      bearing_of_parts(bit_of(pad), plan_of(PartKind::gage_pad, pad_law()), rock());
  const auto area = [](double depth) { return 0.05 * 2.0 * std::sqrt(depth * (0.04 - depth)); };
  const double slope = 10e6 * (area(1e-3) - area(1e-5)) / 1e-3;
  EXPECT_NEAR(b.lateral_slope, 0.5 * slope, 1e-3 * slope);  // of the polygon
  EXPECT_NEAR(b.slope, 0.0, 1e-9 * slope);
}

/// What neither touches nor has a law, and what counts by its cutter's face.
TEST(PartBearing, is_zero_of_all_other_parts) {
  const auto is_zero = [](const bit::Part& part, const ForcePlan& plan) {
    const PartBearing b = bearing_of_parts(bit_of(part), plan, rock());
    return b.at_touch == 0.0 && b.slope == 0.0 && b.lateral_slope == 0.0;
  };
  ForcePlan plan = plan_of(PartKind::bit_body, pad_law());
  bit::Part body = part_of(PartKind::bit_body, block);
  EXPECT_FALSE(is_zero(body, plan));
  body.cutting = bit::Cutting::rubs;
  EXPECT_FALSE(is_zero(body, plan));
  body.cutting = bit::Cutting::never;
  EXPECT_TRUE(is_zero(body, plan));
  EXPECT_TRUE(is_zero(part_of(PartKind::gage_pad, block), plan));
  plan = plan_of(PartKind::cutter_body, pad_law());
  bit::Part of_cutter = part_of(PartKind::cutter_body, block);
  of_cutter.cutter = 0;
  EXPECT_FALSE(is_zero(of_cutter, plan)) << "its face has no law";
  plan.laws[static_cast<std::size_t>(PartKind::face)] = forces::HansonHansen{};
  EXPECT_TRUE(is_zero(of_cutter, plan));
}

/// Bit R as tabled and as solids: one tooth of each row either way.
TEST(PartBearing, of_teeth_counts_one_of_a_row) {
  const auto folder = test_folder();
  const bit::Bit designed = bit::read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  bit::export_solids(folder, designed, {.solids = "stl"});
  const bit::Bit solids = bit::read((folder / "solids.toml").string());
  const ForcePlan plan = plan_of(PartKind::tooth, forces::Indentation{});
  const double by_rows = contact_slopes(designed, plan).axial_stiffness;
  EXPECT_NEAR(contact_slopes(solids, plan).axial_stiffness / by_rows, 1.0, 0.15);
  EXPECT_NEAR(weight_borne(solids, plan, 0.1) / weight_borne(designed, plan, 0.1), 1.0, 0.15);
}

/// A bit with this kind of part and these lines in [forces].
std::string weighted_case(const std::string& kind, const std::string& forces) {
  const auto folder = test_folder();
  const std::string bit_file = write_one_part_bit(
      folder, block, "kind = \"" + kind + "\"\nunit = \"1 m\"\nupdate_direction = [0, 0, 1]\n");
  return write_file(
      folder / "case.toml",
      "[bit]\nfile = \"" + bit_file +
          "\"\n[rock]\nshape = \"flat\"\nradius = \"100 mm\"\nwall = \"10 mm\"\n"
          "edge_length = \"5 mm\"\nmaterial = \"mancos-shale\"\n[motion]\n"
          "kind = \"drilling\"\nrotary_speed = \"60 rpm\"\nweight_on_bit = \"9 kN\"\n"
          "[string]\nmass = \"1000 kg\"\ntorsional_inertia = \"10 kg m2\"\n"
          "bending_inertia = \"10 kg m2\"\nlateral_stiffness = \"1e7 N/m\"\n"
          "bending_stiffness = \"1e6 N m/rad\"\ntorsional_stiffness = \"500 N m/rad\"\n"
          "[time]\nstep = \"1 ms\"\nduration = \"0.1 s\"\n[forces]\n" +
          forces);
}

std::string refusal(const std::string& path) {
  try {
    read_case(path, {});
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

const std::string friction = "law = \"friction\"\nstress = \"20 MPa\"\nmu = 0.3\n";

TEST(WeightOnBit, is_accepted_by_every_bit_that_has_a_law) {
  for (const std::string kind : {"gage-pad", "cse", "cone"})
    EXPECT_EQ(refusal(weighted_case(kind, friction)), "") << kind;
  EXPECT_EQ(refusal(weighted_case("tooth", "law = \"indentation\"\n")), "");
  EXPECT_EQ(refusal(weighted_case("cutter-body", "law = \"none\"\n")), "");  // its own law
}

TEST(WeightOnBit, is_rejected_where_nothing_bears_it) {
  const std::string message = refusal(weighted_case("gage-pad", "law = \"none\"\n"));
  EXPECT_NE(
      message.find("case.toml:12: motion.weight_on_bit: found 9000 N, expected 0 N: no part of "
                   "the bit has a force law that carries weight"),
      std::string::npos)
      << message;
}

TEST(WeightOnBit, is_rejected_beyond_ten_times_what_the_pad_can_carry) {
  const std::string message =
      refusal(weighted_case("gage-pad", "law = \"friction\"\nstress = \"0.1 MPa\"\nmu = 0.3\n"));
  EXPECT_NE(message.find("motion.weight_on_bit: found 9000 N, expected at most 400 N: ten times "
                         "what the bit would carry one gage radius deep in rock"),
            std::string::npos)
      << message;
}

TEST(RunLaw, that_acts_on_no_part_is_rejected_with_those_that_do) {
  const std::string message = refusal(weighted_case("gage-pad", "law = \"indentation\"\n"));
  EXPECT_NE(
      message.find("forces.law: found indentation, expected a law that acts on a part of this "
                   "bit (gage pad): friction"),
      std::string::npos)
      << message;
}

}  // namespace tdbd::simulation::part_bearing_test
