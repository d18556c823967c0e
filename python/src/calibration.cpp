#include <pybind11/stl.h>

#include "calibration/laboratory/laboratory.hpp"
#include "calibration/result/answer.hpp"
#include "python/src/options.hpp"

namespace tdbd::python {
namespace {

/// Reports the progress of cut runs with progress(done, total) from any thread, and ends the runs
/// after an exception.
struct Interrupted {};

std::function<void(long, long)> teller(Watch& watch) {
  return [&watch](long done, long total) {
    watch.look(done, total);
    if (watch.interrupted()) throw Interrupted{};
  };
}

/// Returns the printed answer and the warnings.
std::pair<std::string, Told> calibrate(const calibration::CalibrationCase& c,
                                       const std::string& folder, const std::string& cuts,
                                       bool force, long threads, const py::object& progress) {
  Watch watch(progress);
  calibration::Calibration found;
  std::string answer;
  const calibration::CalibrateOptions options{folder, cuts, overwrite_of(force),
                                              checked_threads(threads), teller(watch)};
  try {
    const py::gil_scoped_release released;
    found = calibration::calibrate_into(c, options);
    answer = calibration::answer_text(c, found);
  } catch (const Interrupted&) {
  }
  watch.rethrow();
  return {answer, found.warnings};
}

void laboratory(const calibration::LaboratoryCase& c, const std::string& file,
                const std::string& cuts, bool force, long threads, const py::object& progress) {
  Watch watch(progress);
  const calibration::LaboratoryOptions options{file, cuts, overwrite_of(force),
                                               checked_threads(threads), teller(watch)};
  try {
    const py::gil_scoped_release released;
    calibration::write_records(c, options);
  } catch (const Interrupted&) {
  }
  watch.rethrow();
}

}  // namespace

void add_calibration(py::module_& m) {
  using py::arg;
  m.def("calibrate", &calibrate, arg("case"), arg("folder"), arg("cuts"), arg("force"),
        arg("threads"), arg("progress"));
  m.def("laboratory", &laboratory, arg("case"), arg("file"), arg("cuts"), arg("force"),
        arg("threads"), arg("progress"));
}

}  // namespace tdbd::python
