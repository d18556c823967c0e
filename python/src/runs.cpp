#include <pybind11/stl.h>

#include "python/src/options.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_run.hpp"

namespace tdbd::python {
namespace {

namespace sim = simulation;

/// Starts or resumes drilling, without the GIL.
template <class Drill>
Told drilled(const sim::Case& c, sim::RunOptions options, Watch& watch, Told& told, Drill&& drill) {
  options.progress = [&](const sim::Simulation& s, long total) {
    watch.look(s.state.steps_done, total);
  };
  options.tell = [&](const sim::CaseWarning& w) { told.push_back(sim::with_place(w)); };
  {
    const py::gil_scoped_release released;
    const sim::RunSummary summary = drill(c, options);
    for (const sim::CaseWarning& w : summary.found_at_end) told.push_back(sim::with_place(w));
  }
  watch.rethrow();
  return told;
}

Told run(const sim::Case& c, const std::string& folder, bool force, long threads,
         const py::object& progress) {
  Watch watch(progress);
  Told told;
  auto options = options_for<sim::RunOptions>(folder, force, watch, told);
  options.threads = checked_threads(threads);
  return drilled(c, options, watch, told,
                 [](const sim::Case& of, const sim::RunOptions& o) { return sim::run(of, o); });
}

/// Resumes drilling, with a later end if `changes` are given.
Told resume_run(const std::string& folder, const std::vector<std::string>& changes, long threads,
                const py::object& progress) {
  Told told;
  const auto warn = [&](const std::string& text) { told.push_back(text); };
  const sim::Case c =
      changes.empty() ? sim::read_stopped_case(folder) : sim::extend_run(folder, changes, warn);
  Watch watch(progress);
  auto options = options_for<sim::RunOptions>(folder, false, watch, told);
  options.threads = checked_threads(threads);
  return drilled(c, options, watch, told, [](const sim::Case& of, const sim::RunOptions& o) {
    return sim::resume_run(of, o);
  });
}

/// Starts or resumes a rotation, without the GIL.
template <class Rotate>
Told rotated(const sim::RotateCase& c, sim::RotateOptions options, Watch& watch, Told& told,
             Rotate&& rotate) {
  options.progress = [&](long done, long total) { watch.look(done, total); };
  {
    const py::gil_scoped_release released;
    const sim::RotateOutcome outcome = rotate(c, options);
    for (const sim::CaseWarning& w : sim::end_warnings(c, outcome.end))
      told.push_back(sim::with_place(w));
  }
  watch.rethrow();
  return told;
}

Told rotate(const sim::RotateCase& c, const std::string& folder, bool force,
            const py::object& progress) {
  Watch watch(progress);
  Told told;
  const auto options = options_for<sim::RotateOptions>(folder, force, watch, told);
  return rotated(
      c, options, watch, told,
      [](const sim::RotateCase& of, const sim::RotateOptions& o) { return sim::rotate(of, o); });
}

/// Resumes a rotation, with a later end if `changes` are given.
Told resume_rotate(const std::string& folder, const std::vector<std::string>& changes,
                   const py::object& progress) {
  Told told;
  const auto warn = [&](const std::string& text) { told.push_back(text); };
  const sim::RotateCase c = changes.empty() ? sim::read_stopped_rotate_case(folder)
                                            : sim::extend_rotate(folder, changes, warn);
  Watch watch(progress);
  const auto options = options_for<sim::RotateOptions>(folder, false, watch, told);
  return rotated(c, options, watch, told,
                 [](const sim::RotateCase& of, const sim::RotateOptions& o) {
                   return sim::resume_rotate(of, o);
                 });
}

}  // namespace

void add_runs(py::module_& m) {
  using py::arg;
  m.def("run", &run, arg("case"), arg("folder"), arg("force"), arg("threads"), arg("progress"));
  m.def("resume_run", &resume_run, arg("folder"), arg("changes"), arg("threads"), arg("progress"));
  m.def("rotate", &rotate, arg("case"), arg("folder"), arg("force"), arg("progress"));
  m.def("resume_rotate", &resume_rotate, arg("folder"), arg("changes"), arg("progress"));
  m.def(
      "tidy_if_finished", [](const std::string& folder) { return sim::tidy_if_finished(folder); },
      arg("folder"));
}

}  // namespace tdbd::python
