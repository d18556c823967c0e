#include "simulation/rotate/rotate_history.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "simulation/rotate/rotate_case.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation::rotate_history_test {

namespace fs = std::filesystem;

constexpr const char* body_text = R"([body]
inertia = [[2, 0, 0], [0, 2.6, 0], [0, 0, 3]]
rotation_vector = [0.1, 0.2, 0.3]
angular_velocity = [0.7, -0.5, 2]
)";

constexpr const char* rest_text = R"([load]
gravity_moment = 3
stiffness = [0, 0, 0.1]
[time]
step = 0.01
duration = 6
)";

std::string cones_text(int count) {
  std::string text;
  for (int k = 0; k < count; ++k)
    text += "[[cones]]\naxis = [" + std::to_string(k) +
            ", 0.5, 0.6]\naxial_inertia = 0.1\nspin = " + std::to_string(3 * k - 4) + "\n";
  return text;
}

/// check_rotate_history.py opens the record of a case with so many cones, and finds in every row
/// what the variables have to do with each other.
void check_with_cones(int cones) {
  const fs::path where = tdbd::temporary_folder() + "tdbd_rotate_history_" + std::to_string(cones);
  fs::remove_all(where);
  fs::create_directories(where);
  std::ofstream(where / "case.toml") << body_text << cones_text(cones) << rest_text;
  const RotateCase c = read_rotate_case(where / "case.toml", {});
  RotateSimulation s = start(c);
  RotateHistory history(where / "history.nc", c);
  history.append(c, s);
  for (int i = 0; i < 600; ++i) {
    advance(c, s, 1);
    history.append(c, s);
    history.append(c, s);  // a step is there once
  }
  history.close();
  const std::string command = std::string("/usr/bin/python3 -B ") + TDBD_SOURCE_DIR +
                              "/verification/simulation/rotate/check_rotate_history.py " +
                              where.string() + " 601 " + std::to_string(cones);
  EXPECT_EQ(std::system(command.c_str()), 0) << cones << " cones";
}

TEST(RotateHistory, holds_what_belongs_together) {
  for (const int cones : {0, 1, 3}) check_with_cones(cones);
}

}  // namespace tdbd::simulation::rotate_history_test
