#include "core/provenance.hpp"
#include "core/units.hpp"
#include "python/src/bindings.hpp"

namespace tdbd::python {
namespace {

py::dict provenance_dict() {
  const Provenance& p = provenance();
  using namespace py::literals;
  return py::dict("version"_a = p.version, "commit"_a = p.commit, "compiler"_a = p.compiler,
                  "flags"_a = p.flags);
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "The compiled half of the package tdbd: the functions that the command line calls.";
  m.attr("provenance") = provenance_dict();
  // Loads the UDUNITS-2 database now: reading it changes the environment for a moment, and no other
  // thread runs yet.
  describe_unit("m");
  add_errors();
  add_files(m);
  add_cases(m);
  add_runs(m);
  add_simulation(m);
  add_rotation(m);
  add_studies(m);
  add_calibration(m);
  add_bits(m);
  add_meshes(m);
  add_sweeps(m);
}

}  // namespace tdbd::python
