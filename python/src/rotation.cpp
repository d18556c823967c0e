#include <pybind11/stl.h>

#include <cmath>

#include "python/src/arrays.hpp"
#include "python/src/live.hpp"
#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::python {
namespace {

namespace sim = simulation;

using Rotating = Live<sim::RotateCase, sim::RotateSimulation>;

Rotating start_rotating(const std::shared_ptr<sim::RotateCase>& c) { return {c, sim::start(*c)}; }

long rotate_steps(Rotating& live, long steps, const py::object& progress) {
  constexpr long block = 1024;  // a step takes a microsecond
  checked_steps(steps);
  return make_steps(live, steps, block, progress,
                    [&](sim::RotateSimulation& s, long n) { sim::advance(*live.of, s, n); });
}

bool rotating_is_done(const Rotating& live, const sim::RotateSimulation& s) {
  return s.steps_done >= live.of->time.steps;
}

std::string rotating_summary(Rotating& live) {
  return read_state(live, [&](const sim::RotateSimulation& s) {
    const auto status =
        rotating_is_done(live, s) ? sim::RunStatus::completed : sim::RunStatus::interrupted;
    return sim::summary_json(*live.of, s, status);
  });
}

/// A property with the type returned by get(live, simulation).
template <class Get>
auto rotating_number(Get get) {
  return [get](Rotating& live) {
    return read_state(live, [&](const sim::RotateSimulation& s) { return get(live, s); });
  };
}

/// A property that is converted to an array; get(case, state).
template <class Get>
auto rotating_array(Get get) {
  return [get](Rotating& live) {
    return array_of(read_state(
        live, [&](const sim::RotateSimulation& s) { return get(*live.of, s.rotating.state); }));
  };
}

using dynamics::RotationState;

std::vector<double> quaternion_of(const sim::RotateCase&, const RotationState& s) {
  return {s.q_WB.w(), s.q_WB.x(), s.q_WB.y(), s.q_WB.z()};
}

void add_rotating_arrays(py::class_<Rotating>& c) {
  c.def_property_readonly(
      "quaternion", rotating_array(&quaternion_of),
      "(4,) Attitude quaternion w, x, y, z, from the body frame to the space frame.");
  c.def_property_readonly(
      "rotation", rotating_array([](const sim::RotateCase&, const RotationState& s) -> Mat3 {
        return s.q_WB.toRotationMatrix();
      }),
      "(3, 3) Rotation matrix from the body frame to the space frame.");
  c.def_property_readonly(
      "angular_velocity",
      rotating_array([](const sim::RotateCase& of, const RotationState& s) -> Vec3 {
        return dynamics::angular_velocity(of.body, s);
      }),
      "(3,) Angular velocity, rad/s, body frame.");
  c.def_property_readonly(
      "momentum", rotating_array([](const sim::RotateCase&, const RotationState& s) -> Vec3 {
        return s.momentum_W;
      }),
      "(3,) Angular momentum of body and cones, N m s, space frame.");
  c.def_property_readonly(
      "cone_angles",
      rotating_array([](const sim::RotateCase&, const RotationState& s) { return s.cone_angles; }),
      "(cones,) Angle of each cone, rad, unwrapped.");
  c.def_property_readonly(
      "cone_momenta",
      rotating_array([](const sim::RotateCase&, const RotationState& s) { return s.cone_momenta; }),
      "(cones,) Angular momentum of each cone about its axis, N m s.");
}

}  // namespace

void add_rotation(py::module_& m) {
  py::class_<Rotating> c(m, "Rotating");
  c.def(py::init(&start_rotating), py::arg("case"));
  c.def("step", &rotate_steps, py::arg("n") = 1, py::arg("progress") = py::none(),
        "Performs n steps, or fewer if the case ends. Returns the number of steps performed.");
  c.def("summary_json", &rotating_summary);
  c.def_property_readonly("time",
                          rotating_number([](const Rotating&, const sim::RotateSimulation& s) {
                            return s.rotating.state.time;
                          }),
                          "Simulated time, s.");
  c.def_property_readonly(
      "steps_done",
      rotating_number([](const Rotating&, const sim::RotateSimulation& s) { return s.steps_done; }),
      "Steps since the start.");
  c.def_property_readonly("done",
                          rotating_number([](const Rotating& l, const sim::RotateSimulation& s) {
                            return rotating_is_done(l, s);
                          }),
                          "Whether the last step of the case has been performed.");
  c.def_property_readonly("energy",
                          rotating_number([](const Rotating& l, const sim::RotateSimulation& s) {
                            return sim::total_energy(*l.of, s.rotating.state);
                          }),
                          "Kinetic and potential energy, J.");
  add_rotating_arrays(c);
}

}  // namespace tdbd::python
