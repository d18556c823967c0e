#include "bit/report/bit_motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "bit/cone/part_pose.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/report/bit_output.hpp"
#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "rotation/rotation_vector.hpp"

namespace tdbd::bit::bit_motion_test {

/// m: places of some 0.2 m after two poses.
constexpr double rounding = 2e-15;

double number(double least, double most) {
  return least + (most - least) * 1e-6 * *rc::gen::inRange(0, 1'000'001);
}

Vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

// The poses of its bodies take every point at rest to where the turned bit has it.
RC_GTEST_PROP(BodyPoses, take_the_bit_at_rest_to_where_it_is, ()) {
  static const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  const std::vector<double> angles{number(-7.0, 7.0), number(-7.0, 7.0), number(-7.0, 7.0)};
  const Pose X_WB{rotation::exp(vector(3.0)), vector(0.1)};
  const BodyPoses poses = body_poses(bit, X_WB, angles, 1.0);
  RC_ASSERT(poses.X_WB.size() == 4U);
  const mesh::TriangleMesh there = merged_mesh(turned(bit, angles), X_WB, nullptr);
  std::size_t v = 0;
  for (const Part& part : bit.parts)
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_W = poses.X_WB[body_of(part)] * (part.X_BP * x_P);
      RC_ASSERT((x_W - there.positions[v++]).norm() < rounding);
    }
}

TEST(BodyPoses, that_cannot_be_written_leave_nothing_behind) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  const std::vector<BodyPoses> frames{body_poses(bit, Pose{}, {}, 0.0)};
  const std::filesystem::path nowhere = std::filesystem::path(temporary_folder()) / "nowhere";
  EXPECT_THROW(write_bit_poses(nowhere / "bit_poses.csv", bit, frames), RunError);
  EXPECT_THROW(write_bit_animation(nowhere / "bit.glb", bit, frames), RunError);
  EXPECT_FALSE(std::filesystem::exists(nowhere));
}

}  // namespace tdbd::bit::bit_motion_test
