#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/temporary_file.hpp"
#include "simulation/case/motion.hpp"

namespace tdbd::simulation::path_table_test {

std::string refusal(const std::string& file) {
  try {
    read_path_table(file);
  } catch (const InputError& e) {
    return e.what();
  }
  return "not refused";
}

TEST(PathTable, columns_are_found_by_name_in_any_order) {
  const std::string file =
      write_temporary(".csv",
                      "z_m,time_s,x_m,y_m,note,rz_rad,rx_rad,ry_rad\n"
                      "3,0,1,2,7,0.6,0.4,0.5\n# a remark\n6,0.5,4,5,7,0,0,0\n");
  const std::vector<PathPoint> path = read_path_table(file);
  ASSERT_EQ(path.size(), 2u);
  EXPECT_EQ(path[0].time, 0.0);
  EXPECT_EQ(path[0].p_WB, Vec3(1, 2, 3));
  EXPECT_EQ(path[0].rotation_WB, Vec3(0.4, 0.5, 0.6));
  EXPECT_EQ(path[1].time, 0.5);
  EXPECT_EQ(path[1].p_WB, Vec3(4, 5, 6));
}

TEST(PathTable, turns_are_summed) {
  const std::string file = write_temporary(
      ".csv",
      "time_s,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad\n0,0,0,0,0,0,0\n1,0,0,0,0,0,3\n2,0,0,0,0,0,6\n");
  const std::vector<PathPoint> path = read_path_table(file);
  EXPECT_EQ(path[0].turned, 0.0);
  EXPECT_NEAR(path[2].turned, 6.0, 1e-14);
}

TEST(PathTable, a_remark_does_not_shift_the_lines_of_messages) {
  const std::string file = write_temporary(
      ".csv",
      "# a path\ntime_s,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad\n0,0,0,0,0,0,0\n\n0,0,0,0,0,0,1\n");
  EXPECT_EQ(refusal(file), file + ":5: time_s: found 0 after 0, expected rising times");
}

TEST(PathTable, a_missing_file_is_named) {
  EXPECT_EQ(refusal("/no/path.csv"), "/no/path.csv: found no such file, expected a CSV table");
}

}  // namespace tdbd::simulation::path_table_test
