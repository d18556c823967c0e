#include <gtest/gtest.h>

#include <cstdlib>

#include "simulation/synthetic_result.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation::draw_test {

int run(const std::string& command) { return std::system(command.c_str()); }

const std::string python = "/usr/bin/python3 ";
const std::string source = TDBD_SOURCE_DIR;

TEST(Draw, figures_of_a_result_are_pictures_and_not_blank) {
  const OutputFolder folder =
      write_synthetic_result(tdbd::temporary_folder() + "tdbd_draw_result", 60, 180);
  const std::string path = folder.path.string();
  ASSERT_EQ(run(python + source + "/reports/draw.py " + path), 0);
  const std::string check =
      python + source + "/verification/simulation/result/check_picture.py " + path;
  EXPECT_EQ(run(check + "/bottom_hole.png 1000 1000 5000"), 0);
  EXPECT_EQ(run(check + "/side_view.png 1500 800 5000"), 0);
  EXPECT_EQ(run(check + "/cutters.png 1000 1000 50"), 0);
}

TEST(Draw, a_folder_without_a_surface_is_an_error) {
  const OutputFolder folder =
      write_synthetic_result(tdbd::temporary_folder() + "tdbd_draw_no_surface", 4, 8);
  std::filesystem::remove(folder.frames() / "rock_final.vtp");
  EXPECT_NE(run(python + source + "/reports/draw.py " + folder.path.string() + " 2>/dev/null"), 0);
}

}  // namespace tdbd::simulation::draw_test
