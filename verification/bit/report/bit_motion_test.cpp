#include "bit/report/bit_motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "bit/cone/part_pose.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/report/bit_output.hpp"
#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "core/read_file.hpp"
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

/// One row for each time and body, in this order, with digits that read back to the bit.
TEST(BodyPoses, are_written_as_rows_of_times_and_bodies) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  std::vector<BodyPoses> frames;
  for (const double time : {0.1, 0.7})
    frames.push_back(
        body_poses(bit, Pose{rotation::exp(Vec3(0.3, -1.1, time)), Vec3(0.1, 0.2, time / 3.0)},
                   {0.1, 2.2, -time}, time));
  const std::filesystem::path file = std::filesystem::path(temporary_folder()) / "bit_poses.csv";
  write_bit_poses(file, bit, frames);
  std::vector<CsvRow> rows = read_csv_rows(file.string());
  rows.erase(rows.begin());  // the header
  ASSERT_EQ(rows.size(), 2U * 4U);
  EXPECT_EQ(read_file(file, "poses").substr(0, read_file(file, "poses").find('\n')),
            "time [s],body,x [m],y [m],z [m],xx,xy,xz,yx,yy,yz,zx,zy,zz");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const BodyPoses& frame = frames[k / 4];
    const Pose& X = frame.X_WB[k % 4];
    ASSERT_EQ(rows[k].cells.size(), 14U);
    const auto cell = [&](std::size_t i) { return csv_number<double>(rows[k].cells[i]).value(); };
    EXPECT_EQ(cell(0), frame.time);
    EXPECT_EQ(rows[k].cells[1], k % 4 == 0 ? "bit" : bit.cones[k % 4 - 1].name);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(cell(static_cast<std::size_t>(2 + i)), X.p(i));
      for (int j = 0; j < 3; ++j)
        EXPECT_EQ(cell(static_cast<std::size_t>(5 + 3 * i + j)), X.R(i, j));
    }
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
