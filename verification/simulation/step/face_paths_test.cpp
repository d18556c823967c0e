#include <gtest/gtest.h>

#include "bit/cutter/cutter.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::simulation::face_paths_test {

constexpr double creep = 1e-3;  // m/s, the slip speed of the shipped law

const bit::Bit& shipped_bit() {
  static const Case c = read_case(TDBD_SOURCE_DIR "/cases/drill-bit-b.toml", {});
  return c.bit;
}

int faces(const bit::Bit& bit) { return static_cast<int>(bit.cutters.size()); }

/// What the bit does in a millisecond with this velocity.
Move move_with(const rotation::Twist& velocity) {
  constexpr double dt = 1e-3;
  return {Pose{}, rotation::carried(velocity, dt), dt, velocity.angular_B.z() * dt, 0};
}

const rotation::Twist drilling{12.0 * Vec3::UnitZ(), 3e-3 * Vec3::UnitZ()};
/// It dithers: hardly down, aside, and backward.
const rotation::Twist dithering{-1e-4 * Vec3::UnitZ(), Vec3(2e-5, -1e-5, 4e-5)};

double tip_speed(const bit::Bit& bit, int cutter, const rotation::Twist& path) {
  return rotation::velocity_B(path, bit::tip_B(bit.cutters[at(cutter)])).norm();
}

void expect_along(const bit::Bit& bit, int cutter, const rotation::Twist& path,
                  const rotation::Twist& way) {
  const double scale = tip_speed(bit, cutter, path) / tip_speed(bit, cutter, way);
  EXPECT_LT((path.angular_B - scale * way.angular_B).norm(), 1e-12 * path.angular_B.norm());
  EXPECT_LT((path.linear_B - scale * way.linear_B).norm(), 1e-12 * path.angular_B.norm());
}

std::vector<double> creep_of_all(const bit::Bit& bit) {
  return std::vector<double>(bit.cutters.size(), creep);
}

TEST(FacePaths, are_those_of_the_step_while_faces_go_forward) {
  const bit::Bit& bit = shipped_bit();
  FacePaths paths;
  follow(bit, move_with(drilling), creep_of_all(bit), paths);
  for (int i = 0; i < faces(bit); ++i) {
    EXPECT_FALSE(creeps(paths, i));
    EXPECT_EQ(path_of(paths, bit, i, dithering).linear_B, dithering.linear_B);
  }
}

/// As fast as the step's own path moves the tip, but along the way that the face last went.
TEST(FacePaths, keep_the_last_path_of_faces_that_creep) {
  const bit::Bit& bit = shipped_bit();
  FacePaths paths;
  follow(bit, move_with(drilling), creep_of_all(bit), paths);
  follow(bit, move_with(dithering), creep_of_all(bit), paths);
  for (int i = 0; i < faces(bit); ++i) {
    ASSERT_TRUE(creeps(paths, i));
    const rotation::Twist path = path_of(paths, bit, i, dithering);
    const double speed = tip_speed(bit, i, dithering);
    EXPECT_NEAR(tip_speed(bit, i, path), speed, 1e-12 * speed);
    expect_along(bit, i, path, drilling);
  }
}

TEST(FacePaths, of_a_bit_that_never_moved_are_around_its_axis) {
  const bit::Bit& bit = shipped_bit();
  FacePaths paths;
  follow(bit, move_with(dithering), creep_of_all(bit), paths);
  for (int i = 0; i < faces(bit); ++i) {
    ASSERT_TRUE(creeps(paths, i));
    expect_along(bit, i, path_of(paths, bit, i, dithering), {Vec3::UnitZ(), Vec3::Zero()});
  }
}

/// A bit that is thrown backward or aside goes its own way, however it turns.
TEST(FacePaths, are_those_of_the_step_when_faces_move_fast_in_any_direction) {
  const bit::Bit& bit = shipped_bit();
  FacePaths paths;
  follow(bit, move_with({Vec3::Zero(), -0.5 * Vec3::UnitZ()}), creep_of_all(bit), paths);
  for (int i = 0; i < faces(bit); ++i) EXPECT_FALSE(creeps(paths, i));
}

/// The speed below which the faces' law slips; of no law there is none.
TEST(FacePaths, creep_below_the_slip_speed_of_the_law) {
  const Case shipped = read_case(TDBD_SOURCE_DIR "/cases/drill-bit-b.toml", {});
  EXPECT_EQ(creep_speeds(shipped.bit, shipped.forces), creep_of_all(shipped.bit));
  EXPECT_EQ(creep_speeds(shipped.bit, ForcePlan{}),
            std::vector<double>(shipped.bit.cutters.size(), 0.0));
}

TEST(FacePaths, are_none_before_the_first_step) { EXPECT_FALSE(creeps({}, 0)); }

}  // namespace tdbd::simulation::face_paths_test
