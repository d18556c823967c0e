#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "simulation/start/rock_start.hpp"

namespace tdbd::simulation::rock_memory_test {

constexpr double pi = std::numbers::pi;

/// A bit of 0.1 m that goes `depth` (m) down in 10 s, in rock with edges of 1 mm.
Case drilling(double depth) {
  Case c;
  c.bit.gage_radius = 0.1;
  c.motion.rate_of_penetration = depth / 10.0;
  c.time = {.step = 0.01, .steps = 1000};
  c.rock.edge_length = 1e-3;
  c.places.edge_length = "case.toml:3: rock.edge_length";
  return c;
}

void expect_box(const mesh::Box& box, const Vec3& lo, const Vec3& hi) {
  EXPECT_LT((box.lo - lo).norm(), 1e-12);
  EXPECT_LT((box.hi - hi).norm(), 1e-12);
}

TEST(Reach, is_the_path_of_the_bit_widened_by_its_size) {
  expect_box(reach_W(drilling(2.0)), {-0.1, -0.1, 0.0}, {0.1, 0.1, 2.0});
  Case whirling = drilling(-3.0);
  whirling.motion.whirl.radius = 0.02;
  expect_box(reach_W(whirling), {-0.12, -0.12, -3.0}, {0.12, 0.12, 0.0});
}

TEST(Reach, of_a_resumed_run_begins_where_it_resumes) {
  Case c = drilling(2.0);
  c.time.first = 500;
  expect_box(reach_W(c), {-0.1, -0.1, 1.0}, {0.1, 0.1, 2.0});
}

TEST(Reach, contains_every_row_of_a_path) {
  Case c = drilling(0.0);
  c.motion.kind = MotionKind::table;
  c.motion.path = {{0.0, Vec3::Zero(), Vec3::Zero()},
                   {5.0, Vec3(1.0, -2.0, 3.0), Vec3::Zero()},
                   {10.0, Vec3::Zero(), Vec3::Zero()}};
  expect_box(reach_W(c), {-0.1, -2.1, 0.0}, {1.1, 0.1, 3.0});
}

/// Equilateral triangles, sqrt(3)/4 of the edge squared; cells of two edges.
TEST(RockRequirements, is_that_of_equilateral_triangles_and_of_the_cells_of_the_box) {
  mesh::Box box;
  box.add(Vec3::Zero());
  box.add(Vec3(0.2, 0.4, 0.6));
  const RockRequirements need = rock_requirements(std::sqrt(3.0), box, 0.1);
  EXPECT_NEAR(need.triangles, 400.0, 1e-12);
  EXPECT_NEAR(need.cells, 2.0 * 3.0 * 4.0, 1e-12);
  EXPECT_DOUBLE_EQ(need.bytes, bytes_of_triangles(400.0) + 4.2 * 24.0);
}

/// The cylinder that the gage leaves.
TEST(RockRequirements, of_the_new_wall_is_that_of_the_gages_cylinder) {
  const Case c = drilling(2.0);
  EXPECT_DOUBLE_EQ(new_wall_requirements(c).triangles,
                   2.0 * pi * 0.1 * 2.0 / (std::sqrt(3.0) / 4.0 * 1e-6));
}

/// What is refused, in its own words; empty: nothing.
std::string refusal(const Case& c, double area, const mesh::Box& box_W) {
  try {
    require_memory(c, area, box_W);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// Up or down a kilometre: more cells and triangles than 32 bits count.
TEST(RequireMemory, counts_the_rock_and_the_whole_path) {
  mesh::Box small;
  small.add(Vec3::Zero());
  small.add(Vec3(0.01, 0.01, 0.01));
  EXPECT_EQ(refusal(drilling(1.0), 0.01, small), "");
  for (const double depth : {1000.0, -1000.0}) {
    const std::string found = refusal(drilling(depth), 0.01, small);
    EXPECT_EQ(found.rfind("case.toml:3: rock.edge_length: found 0.001 m, which makes 1.5e+09 "
                          "triangles and 5.1e+09 cells of rock on a way of 1e+03 m and needs ",
                          0),
              0U)
        << found;
  }
}

/// An edge length that it names would do, and hardly a larger one.
TEST(RequireMemory, names_an_edge_length_that_would_do) {
  const Case c = drilling(1000.0);
  const std::string found = refusal(c, 0.0, reach_W(c));
  double edge = 0.0;
  const auto at = found.rfind(": ");
  ASSERT_NE(at, std::string::npos);
  ASSERT_EQ(std::sscanf(found.c_str() + at, ": %lg m is enough", &edge), 1) << found;
  Case coarser = c, finer = c;
  coarser.rock.edge_length = 1.05 * edge;  // two digits are shown
  finer.rock.edge_length = edge / 1.2;
  EXPECT_EQ(refusal(coarser, 0.0, reach_W(c)), "");
  EXPECT_NE(refusal(finer, 0.0, reach_W(c)), "");
}

}  // namespace tdbd::simulation::rock_memory_test
