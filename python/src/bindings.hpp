#pragma once

#include <pybind11/pybind11.h>

namespace tdbd::python {

namespace py = pybind11;

// Each function adds the bindings of one file to the module.
void add_errors();
void add_files(py::module_& m);
void add_cases(py::module_& m);
void add_runs(py::module_& m);
void add_simulation(py::module_& m);
void add_rotation(py::module_& m);
void add_studies(py::module_& m);
void add_calibration(py::module_& m);
void add_bits(py::module_& m);
void add_meshes(py::module_& m);
void add_sweeps(py::module_& m);

}  // namespace tdbd::python
