#include "simulation/step/simulation.hpp"

#include <pybind11/stl.h>

#include <numbers>
#include <tuple>

#include "core/parallel.hpp"
#include "python/src/arrays.hpp"
#include "python/src/live.hpp"
#include "python/src/options.hpp"
#include "simulation/result/run.hpp"

namespace tdbd::python {
namespace {

namespace sim = simulation;

using Drilling = Live<sim::Case, sim::Simulation>;

Drilling start_drilling(const std::shared_ptr<sim::Case>& c, long threads) {
  const int count = checked_threads(threads);
  const py::gil_scoped_release released;
  const ThreadLimit limit(count);
  return {c, sim::start(*c), count};
}

long drill_steps(Drilling& live, long steps, const py::object& progress) {
  checked_steps(steps);
  return make_steps(live, steps, 1, progress, [&](sim::Simulation& s, long) {
    const ThreadLimit limit(live.threads);
    sim::step(*live.of, s);
  });
}

bool drilling_is_done(const Drilling& live, const sim::Simulation& s) {
  return s.state.steps_done >= live.of->time.steps;
}

std::string drilling_summary(Drilling& live) {
  return read_state(live, [&](const sim::Simulation& s) {
    const auto status =
        drilling_is_done(live, s) ? sim::RunStatus::completed : sim::RunStatus::interrupted;
    sim::RunSummary summary = sim::summary_of(*live.of, s, status);
    if (summary.drive) summary.drive->order.residual.reason = "only observed in a run";
    return sim::to_json(summary);
  });
}

/// Vertices, faces, and the part that cut each vertex last.
py::tuple drilling_surface(Drilling& live) {
  auto [m, parts] = read_state(live, [](const sim::Simulation& s) {
    std::vector<int> slots;
    mesh::TriangleMesh of = mesh::compact(s.state.rock.surface, &slots);
    for (int& slot : slots) slot = s.state.rock.last_part[at(slot)];
    return std::make_tuple(std::move(of), std::move(slots));
  });
  return py::make_tuple(array_of(m.positions), array_of(m.triangles), array_of(parts));
}

std::vector<double> removed_of(const sim::Simulation& s) {
  std::vector<double> removed;
  for (const CompensatedSum& sum : s.state.ledger.removed_by_part) removed.push_back(sum.value());
  return removed;
}

/// A property with the type returned by get(live, simulation).
template <class Get>
auto number(Get get) {
  return [get](Drilling& live) {
    return read_state(live, [&](const sim::Simulation& s) { return get(live, s); });
  };
}

/// A property that is converted to an array.
template <class Get>
auto array(Get get) {
  return [get](Drilling& live) {
    return array_of(read_state(live, [&](const sim::Simulation& s) { return get(s); }));
  };
}

void add_numbers(py::class_<Drilling>& c) {
  c.def_property_readonly("time", number([](const Drilling& l, const sim::Simulation& s) {
                            return sim::time_at(l.of->time, s.state.steps_done);
                          }),
                          "Simulated time, s.");
  c.def_property_readonly("steps_done", number([](const Drilling&, const sim::Simulation& s) {
                            return s.state.steps_done;
                          }),
                          "Steps since the start of the motion.");
  c.def_property_readonly("done", number([](const Drilling& l, const sim::Simulation& s) {
                            return drilling_is_done(l, s);
                          }),
                          "Whether the last step of the case has been performed.");
  c.def_property_readonly("revolutions", number([](const Drilling&, const sim::Simulation& s) {
                            return (s.state.place.turned - s.state.start_turned) /
                                   (2.0 * std::numbers::pi);
                          }),
                          "Revolutions of the bit since the start.");
  c.def_property_readonly("removed_volume", number([](const Drilling&, const sim::Simulation& s) {
                            return s.state.ledger.removed.value();
                          }),
                          "Rock removed since the start, m3.");
  c.def_property_readonly(
      "volume_ledger_defect",
      number([](const Drilling&, const sim::Simulation& s) { return sim::ledger_defect(s); }),
      "Relative residual of the volume balance of the rock; at rounding level.");
}

void add_arrays(py::class_<Drilling>& c) {
  c.def_property_readonly(
      "position", array([](const sim::Simulation& s) -> Vec3 { return s.state.place.X_WB.p; }),
      "(3,) Origin of the bit, m, space frame, z down the hole.");
  c.def_property_readonly(
      "rotation", array([](const sim::Simulation& s) -> Mat3 { return s.state.place.X_WB.R; }),
      "(3, 3) Rotation matrix from the bit frame to the space frame.");
  c.def_property_readonly(
      "force", array([](const sim::Simulation& s) -> Vec3 { return s.work.loads.force_W; }),
      "(3,) Force of the rock on the bit in the last step, N, space frame; 0 without a force law.");
  c.def_property_readonly(
      "torque", array([](const sim::Simulation& s) -> Vec3 { return s.work.loads.torque_W; }),
      "(3,) Torque of the rock about the bit's origin in the last step, N m, space frame; 0 "
      "without a "
      "force law.");
  c.def_property_readonly("removed_by_part", array(&removed_of),
                          "(parts,) Rock removed by each part since the start, m3.");
  c.def_property_readonly(
      "removed_in_step",
      array([](const sim::Simulation& s) { return s.state.cut.removed_by_part; }),
      "(parts,) Rock removed by each part in the last step, m3; empty before the first.");
  c.def_property_readonly(
      "cone_angles", array([](const sim::Simulation& s) { return sim::angles_of(s.state.cones); }),
      "(cones,) Angle of each cone about its axis since the start, rad.");
  c.def_property_readonly(
      "cone_speeds", array([](const sim::Simulation& s) { return sim::speeds_of(s.state.cones); }),
      "(cones,) Speed of each cone in the last step, rad/s.");
}

}  // namespace

void add_simulation(py::module_& m) {
  py::class_<Drilling> c(m, "Drilling");
  c.def(py::init(&start_drilling), py::arg("case"), py::arg("threads"));
  c.def("step", &drill_steps, py::arg("n") = 1, py::arg("progress") = py::none(),
        "Performs n steps, or fewer if the case ends. Returns the number of steps performed.");
  c.def("summary_json", &drilling_summary);
  c.def("surface", &drilling_surface);
  add_numbers(c);
  add_arrays(c);
}

}  // namespace tdbd::python
