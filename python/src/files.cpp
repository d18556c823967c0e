#include "mesh/files/files.hpp"

#include <H5Epublic.h>
#include <pybind11/stl.h>

#include "io/netcdf_file.hpp"
#include "python/src/arrays.hpp"

namespace tdbd::python {
namespace {

/// The NetCDF lock as a Python context manager.
struct FilesLock {
  void enter() const {
    const py::gil_scoped_release released;  // the holder of the lock may need the GIL to continue
    netcdf_mutex().lock();
    H5Eset_auto(H5E_DEFAULT, nullptr,
                nullptr);  // NetCDF queries objects that may be absent; per thread
  }
  void exit() const { netcdf_mutex().unlock(); }
};

py::tuple surface_of(const std::string& path) {
  mesh::TriangleMesh m;
  {
    const py::gil_scoped_release released;
    m = mesh::read_mesh(path, mesh::unit_or(path, 1.0));
  }
  return py::make_tuple(array_of(m.positions), array_of(m.triangles));
}

}  // namespace

void add_files(py::module_& m) {
  py::class_<FilesLock>(m, "FilesLock")
      .def(py::init<>())
      .def(
          "__enter__",
          [](FilesLock& lock) -> FilesLock& {
            lock.enter();
            return lock;
          },
          py::return_value_policy::reference)
      .def("__repr__", [](const FilesLock&) { return "<tdbd.FilesLock>"; })
      .def("__exit__", [](FilesLock& lock, const py::args&) { lock.exit(); });
  m.def("read_surface", &surface_of, py::arg("path"),
        "Vertices (n, 3), m, and faces (m, 3) of a mesh file. It is in metres unless its header "
        "states "
        "another unit.");
}

}  // namespace tdbd::python
