#include "app/rotate_folder.hpp"

namespace tdbd::app {
namespace {

constexpr const char* rotate_case_text = R"(title = "all keys"
[body]
inertia = [[2, 0, 0], [0, "2.6 kg m2", 0], [0, 0, 3]]
rotation_vector = ["20 deg", 0.1, 0]
angular_velocity = [0.5, -0.4, "20 rpm"]
[[cones]]
axis = [0.8, 0, 0.6]
axial_inertia = 0.1
spin = "-60 rpm"
angle = 0.5
torque = 0.01
[[cones]]
axis = [-0.4, 0.7, 0.6]
axial_inertia = 0.2
spin = 4
damping = 0.01
[load]
body_torque = [0.1, 0, 0]
gravity_moment = "5 N m"
gravity_arm = [0.6, 0, 0.8]
stiffness = [0, 0, 1]
damping = [0.1, 0.1, 0.1]
[[load.harmonics]]
frame = "space"
amplitude = [0, 0.3, 0]
angular_frequency = "60 rpm"
phase = 0.3
[[load.samples]]
frame = "body"
file = "torque.csv"
[integrator]
drift = "split"
[time]
step = "10 ms"
duration = 2
)";

/// A box of 1 m x 2 m x 3 m off the origin.
constexpr const char* box_text = R"(OFF
8 12 0
5 0 0
6 0 0
6 2 0
5 2 0
5 0 3
6 0 3
6 2 3
5 2 3
3 0 2 1
3 0 3 2
3 4 5 6
3 4 6 7
3 0 1 5
3 0 5 4
3 1 2 6
3 1 6 5
3 2 3 7
3 2 7 6
3 3 0 4
3 3 4 7
)";

}  // namespace

const char* const free_body_text = R"([body]
inertia = [[2, 0, 0], [0, 2.6, 0], [0, 0, 3]]
angular_velocity = [0.7, -0.5, 2]
[[cones]]
axis = [0.8, 0, 0.6]
axial_inertia = 0.1
spin = -7
[[cones]]
axis = [-0.4, 0.7, 0.6]
axial_inertia = 0.2
spin = 3
[time]
step = 0.02
duration = 2
)";

RotateFolder::RotateFolder() {
  write("case.toml", rotate_case_text);
  write("box.off", box_text);
  write("torque.csv", "time_s,x,y,z\n0,0,0,0\n1,0.1,0,0.2\n3,0,0,0\n");
}

battery::Outcome RotateFolder::rotate(std::vector<std::string> more, const std::string& out,
                                      const battery::Surroundings& around) const {
  more.insert(more.begin(), {"rotate", path("case.toml"), "-o", path(out)});
  return battery::run_tdbd(more, around);
}

battery::Outcome RotateFolder::converge(std::vector<std::string> more,
                                        const std::string& out) const {
  more.insert(more.begin(), {"converge", path("case.toml"), "-o", path(out)});
  return battery::run_tdbd(more);
}

}  // namespace tdbd::app
