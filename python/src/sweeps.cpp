#include <pybind11/stl.h>

#include "core/error.hpp"
#include "python/src/options.hpp"
#include "sweep/sweep.hpp"

namespace tdbd::python {
namespace {

using namespace py::literals;

/// Runs the points of a shard; see SweepResult.
py::dict run_sweep(const std::string& design, const std::string& table,
                   const std::pair<long, long>& shard, long threads, const py::object& progress) {
  Watch watch(progress);
  sweep::SweepOptions options{
      table, {shard.first, shard.second}, checked_threads(threads), &watch.interrupted(), {}};
  options.progress = [&watch](long done, long total) { watch.look(done, total); };
  sweep::SweepResult r;
  {
    const py::gil_scoped_release released;
    r = sweep::run_sweep(sweep::read_design(design), options);
  }
  watch.rethrow();
  return py::dict("points"_a = r.points, "of_shard"_a = r.of_shard, "found"_a = r.found,
                  "failed"_a = r.failed, "done"_a = r.done, "on_front"_a = r.on_front,
                  "written"_a = r.written, "first_failure"_a = r.first_failure);
}

/// The overrides of every point.
std::vector<std::vector<std::string>> sweep_points(const std::string& design) {
  const sweep::Design d = sweep::read_design(design);
  const sweep::Points points = sweep::points_of(d);
  std::vector<std::vector<std::string>> all;
  for (long i = 0; i < points.count; ++i) all.push_back(sweep::overrides_at(d, points, i));
  return all;
}

/// Runs the first point and returns the names of the numbers of its summary.
std::vector<std::string> sweep_figures(const std::string& design, const std::string& cuts) {
  const sweep::Design d = sweep::read_design(design);
  return sweep::figures_on_offer(d, sweep::overrides_at(d, sweep::points_of(d), 0), cuts);
}

}  // namespace

void add_sweeps(py::module_& m) {
  using py::arg;
  using Free = py::call_guard<py::gil_scoped_release>;
  m.def("run_sweep", &run_sweep, arg("design"), arg("table"), arg("shard"), arg("threads"),
        arg("progress"));
  m.def("sweep_points", &sweep_points, arg("design"), Free());
  m.def("sweep_figures", &sweep_figures, arg("design"), arg("cuts"), Free());
}

}  // namespace tdbd::python
