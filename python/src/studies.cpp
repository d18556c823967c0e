#include <pybind11/stl.h>

#include <optional>

#include "python/src/options.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_simulation.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/study/convergence_output.hpp"

namespace tdbd::python {
namespace {

namespace sim = simulation;
using namespace py::literals;

/// Arguments of a study besides its case, in the order of Python's keywords.
struct StudyWords {
  std::vector<std::string> over;
  int levels;
  double factor;
  std::optional<std::string> reference;
};

sim::ConvergencePlan plan_of(const std::string& path, const std::vector<std::string>& overrides,
                             const StudyWords& words) {
  sim::ConvergencePlan plan{path, overrides, words.over, words.levels, words.factor, {}};
  if (words.reference) plan.reference = sim::read_end_state_file(*words.reference);
  return plan;
}

/// Returns convergence.json and the table for a terminal. Writes nothing if there is no folder.
py::tuple converge(const std::string& path, const std::vector<std::string>& overrides,
                   const StudyWords& words, const std::optional<std::string>& folder, bool force,
                   long threads, const py::object& progress) {
  Watch watch(progress);
  sim::ConvergenceOptions options;
  options.threads = checked_threads(threads);
  options.interrupted = &watch.interrupted();
  options.progress = [&](int level, long done, long total) {
    watch.look(total * (level - 1) + done, total * words.levels);
  };
  std::string json, table;
  {
    const py::gil_scoped_release released;
    const sim::ConvergencePlan plan = plan_of(path, overrides, words);
    const sim::Convergence found =
        folder ? sim::converge_into({*folder, overwrite_of(force), words.reference.value_or("")},
                                    plan, options)
               : sim::converge(plan, options);
    json = sim::to_json(found);
    table = sim::table_text(found);
  }
  watch.rethrow();
  return py::make_tuple(json, table);
}

py::dict check_drilling(const sim::Case& c) {
  Told warnings;
  sim::RunEstimate e;
  long triangles = 0;
  {
    const py::gil_scoped_release released;
    sim::Simulation s = sim::start(c);
    triangles = s.state.start_triangles;
    for (const sim::CaseWarning& w : sim::reach_warnings(c, s.state.rock.surface))
      warnings.push_back(sim::with_place(w));
    e = sim::estimate(c, s);
  }
  return py::dict("triangles"_a = triangles, "triangles_at_end"_a = e.triangles,
                  "memory_bytes"_a = e.memory_bytes, "disk_bytes"_a = e.disk_bytes,
                  "seconds"_a = e.seconds, "steps_tried"_a = e.steps_tried,
                  "warnings"_a = warnings);
}

py::dict check_rotation(const sim::RotateCase& c) {
  const sim::RotateSimulation s = sim::start(c);
  return py::dict("cones"_a = c.body.cones.size(), "energy"_a = s.invariants.energy);
}

}  // namespace

void add_studies(py::module_& m) {
  using py::arg;
  py::class_<StudyWords>(m, "StudyWords")
      .def(py::init<std::vector<std::string>, int, double, std::optional<std::string>>(),
           arg("over"), arg("levels"), arg("factor"), arg("reference"));
  m.def("converge", &converge, arg("path"), arg("overrides"), arg("words"), arg("folder"),
        arg("force"), arg("threads"), arg("progress"));
  m.def("check_drilling", &check_drilling, arg("case"));
  m.def("check_rotation", &check_rotation, arg("case"));
}

}  // namespace tdbd::python
