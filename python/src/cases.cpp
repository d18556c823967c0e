#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <utility>

#include "calibration/case/calibration_case.hpp"
#include "calibration/laboratory/laboratory.hpp"
#include "core/error.hpp"
#include "python/src/bindings.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/rotate/rotate_case.hpp"

namespace tdbd::python {
namespace {

using calibration::CalibrationCase;
using calibration::LaboratoryCase;
using simulation::Case;
using simulation::CaseKind;
using simulation::RotateCase;

constexpr std::array<std::pair<CaseKind, const char*>, 8> kind_names{
    {{CaseKind::drilling, "drilling"},
     {CaseKind::rotation, "rotation"},
     {CaseKind::calibration, "calibration"},
     {CaseKind::laboratory, "laboratory"},
     {CaseKind::sweep, "sweep"},
     {CaseKind::string, "string"},
     {CaseKind::bit, "bit"},
     {CaseKind::unknown, "unknown"}}};

using Overrides = std::vector<std::string>;

std::string kind_of(const std::string& path, const Overrides& overrides) {
  const CaseKind kind = simulation::kind_of(path, overrides);
  for (const auto& [named, name] : kind_names)
    if (named == kind) return name;
  throw RunError("a kind of case without a name");
}

void require_kind(const std::string& path, const Overrides& overrides,
                  const std::vector<std::string>& expected) {
  std::vector<CaseKind> kinds;
  for (const auto& [kind, name] : kind_names)
    for (const std::string& wanted : expected)
      if (wanted == name) kinds.push_back(kind);
  simulation::require_kind(path, overrides, kinds);
}

/// Reads a case into a shared pointer. Called without the GIL.
template <class C, C (*read)(const std::string&, const Overrides&)>
std::shared_ptr<C> read_shared(const std::string& path, const Overrides& overrides) {
  return std::make_shared<C>(read(path, overrides));
}

Case read_drilling(const std::string& path, const Overrides& overrides) {
  return simulation::read_case(path, overrides);
}

std::vector<std::string> warnings_of(const Case& c) {
  std::vector<std::string> texts;
  for (const simulation::CaseWarning& w : c.warnings) texts.push_back(simulation::with_place(w));
  return texts;
}

std::vector<std::string> part_names(const Case& c) {
  std::vector<std::string> names;
  for (const bit::Part& p : c.bit.parts) names.push_back(p.name);
  return names;
}

}  // namespace

void add_cases(py::module_& m) {
  using Free = py::call_guard<py::gil_scoped_release>;
  m.def("kind_of", &kind_of, py::arg("path"), py::arg("overrides"));
  m.def("require_kind", &require_kind, py::arg("path"), py::arg("overrides"), py::arg("expected"));
  m.def("read_drilling", &read_shared<Case, read_drilling>, py::arg("path"), py::arg("overrides"),
        Free());
  m.def("read_rotation", &read_shared<RotateCase, simulation::read_rotate_case>, py::arg("path"),
        py::arg("overrides"), Free());
  m.def("read_calibration", &read_shared<CalibrationCase, calibration::read_calibration>,
        py::arg("path"), py::arg("overrides"), Free());
  m.def("read_laboratory", &read_shared<LaboratoryCase, calibration::read_laboratory>,
        py::arg("path"), py::arg("overrides"), Free());
  py::class_<Case, std::shared_ptr<Case>>(m, "DrillingCase")
      .def_readonly("resolved", &Case::resolved)
      .def_readonly("hash", &Case::hash)
      .def_readonly("quantities", &Case::quantities)
      .def_property_readonly("title", [](const Case& c) { return c.bit.name; })
      .def_property_readonly("steps", [](const Case& c) { return c.time.steps; })
      .def_property_readonly("step", [](const Case& c) { return c.time.step; })
      .def_property_readonly("warnings", &warnings_of)
      .def_property_readonly("parts", &part_names);
  py::class_<RotateCase, std::shared_ptr<RotateCase>>(m, "RotationCase")
      .def_readonly("resolved", &RotateCase::resolved)
      .def_readonly("hash", &RotateCase::hash)
      .def_readonly("quantities", &RotateCase::quantities)
      .def_readonly("title", &RotateCase::title)
      .def_property_readonly("steps", [](const RotateCase& c) { return c.time.steps; })
      .def_property_readonly("step", [](const RotateCase& c) { return c.time.step; });
  py::class_<CalibrationCase, std::shared_ptr<CalibrationCase>>(m, "CalibrationCase")
      .def_readonly("resolved", &CalibrationCase::resolved)
      .def_readonly("hash", &CalibrationCase::hash);
  py::class_<LaboratoryCase, std::shared_ptr<LaboratoryCase>>(m, "LaboratoryCase")
      .def_property_readonly("resolved", [](const LaboratoryCase& c) { return c.setup.resolved; })
      .def_property_readonly("hash", [](const LaboratoryCase& c) { return c.setup.hash; });
}

}  // namespace tdbd::python
