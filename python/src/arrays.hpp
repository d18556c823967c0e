#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"
#include "python/src/bindings.hpp"

namespace tdbd::python {

// Returns copies, never views: a view would change or dangle when the simulation takes a step.

inline py::array_t<double> array_of(const std::vector<double>& x) {
  return py::array_t<double>(static_cast<py::ssize_t>(x.size()), x.data());
}

inline py::array_t<int> array_of(const std::vector<int>& x) {
  return py::array_t<int>(static_cast<py::ssize_t>(x.size()), x.data());
}

inline py::array_t<double> array_of(const Vec3& x) {
  return py::array_t<double>(py::ssize_t{3}, x.data());
}

/// (3, 3), in row-major order; Eigen stores columns contiguously.
inline py::array_t<double> array_of(const Mat3& m) {
  const Mat3 rows = m.transpose();
  return py::array_t<double>({py::ssize_t{3}, py::ssize_t{3}}, rows.data());
}

/// (n, 3)
inline py::array_t<double> array_of(const std::vector<Vec3>& x) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return py::array_t<double>({static_cast<py::ssize_t>(x.size()), py::ssize_t{3}},
                             reinterpret_cast<const double*>(x.data()));
}

/// (m, 3)
inline py::array_t<int> array_of(const std::vector<mesh::Triangle>& x) {
  return py::array_t<int>({static_cast<py::ssize_t>(x.size()), py::ssize_t{3}},
                          reinterpret_cast<const int*>(x.data()));
}

}  // namespace tdbd::python
