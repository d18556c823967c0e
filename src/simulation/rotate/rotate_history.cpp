#include "simulation/rotate/rotate_history.hpp"

#include <fmt/format.h>

#include "rotation/rotation_vector.hpp"

namespace tdbd::simulation {
namespace {

enum Axis { none = -1, xyz, quaternion, cone };

/// The columns, in the order in which row_of fills them.
std::vector<RecordColumn> columns() {
  return {
      {"time", "s", "time"},
      {"quaternion", "1", "attitude of the bit, unit quaternion, bit to space", quaternion},
      {"rotation_vector", "rad", "attitude of the bit, rotation vector, bit to space", xyz},
      {"angular_velocity", "rad/s", "angular velocity of the bit, bit frame", xyz},
      {"body_momentum", "N m s", "angular momentum of bit and cones, bit frame", xyz},
      {"space_momentum", "N m s", "angular momentum of bit and cones, space frame", xyz},
      {"cone_angle", "rad", "angle of the cone about its axis, unwrapped", cone},
      {"cone_momentum", "N m s", "angular momentum of the cone about its axis", cone},
      {"cone_spin", "rad/s", "speed of the cone about its axis, seen from the bit", cone},
      {"kinetic_energy", "J", "kinetic energy of bit and cones"},
      {"potential_energy", "J", "potential energy of gravity and springs"},
      {"total_energy", "J", "kinetic and potential energy"},
      {"twist", "rad", "turn about the vertical, swing-twist, unwrapped"},
      {"axis_W", "1", "third axis of the bit in space, R e3: the axis of a top", xyz},
  };
}

RecordLayout layout_for(const RotateCase& c) {
  RecordLayout layout;
  layout.axes = {{"xyz", {"x", "y", "z"}}, {"quaternion_part", {"w", "x", "y", "z"}}, {"cone", {}}};
  for (std::size_t k = 0; k < c.body.cones.size(); ++k)
    layout.axes[cone].components.push_back(fmt::format("{}", k + 1));
  layout.columns = columns();
  layout.labels = {{"xyz", "component", xyz, layout.axes[xyz].components},
                   {"quaternion_part", "scalar and vector part", quaternion,
                    layout.axes[quaternion].components}};
  return layout;
}

void add(std::vector<double>& row, const Vec3& v) { row.insert(row.end(), {v.x(), v.y(), v.z()}); }

void row_of(const RotateCase& c, const dynamics::RotationState& s, std::vector<double>& row) {
  const Mat3 R_WB = s.q_WB.toRotationMatrix();
  const Vec3 w_B = dynamics::angular_velocity(c.body, s);
  const double kinetic = dynamics::kinetic_energy(c.body, s);
  const double potential = dynamics::potential_energy(c.loads, s);
  row = {s.time, s.q_WB.w(), s.q_WB.x(), s.q_WB.y(), s.q_WB.z()};
  add(row, rotation::log(R_WB));
  add(row, w_B);
  add(row, dynamics::body_momentum(s));
  add(row, s.momentum_W);
  row.insert(row.end(), s.cone_angles.begin(), s.cone_angles.end());
  row.insert(row.end(), s.cone_momenta.begin(), s.cone_momenta.end());
  for (std::size_t k = 0; k < c.body.cones.size(); ++k)
    row.push_back(dynamics::cone_rate(c.body.cones[k], s.cone_momenta[k], w_B));
  row.insert(row.end(), {kinetic, potential, kinetic + potential, twist(s)});
  add(row, R_WB.col(2));
}

}  // namespace

RotateHistory::RotateHistory(const std::filesystem::path& path, const RotateCase& c)
    : width_(layout_for(c).row_width()), record_(path, layout_for(c)) {}

bool RotateHistory::append(const RotateCase& c, const RotateSimulation& s) {
  if (s.steps_done == last_step_) return false;
  row_of(c, s.rotating.state, row_);
  record_.append(row_);
  last_step_ = s.steps_done;
  return true;
}

}  // namespace tdbd::simulation
