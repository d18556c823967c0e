#include <pybind11/stl.h>

#include <algorithm>
#include <memory>

#include "bit/cone/swept_parts.hpp"
#include "bit/files/bit_export.hpp"
#include "bit/files/bit_file.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "bit/report/bit_output.hpp"
#include "bit/report/bit_report.hpp"
#include "bit/report/cone_report.hpp"
#include "core/units.hpp"
#include "mesh/measures.hpp"
#include "python/src/arrays.hpp"
#include "python/src/options.hpp"

namespace tdbd::python {
namespace {

using bit::BitFile;
using namespace py::literals;

std::shared_ptr<BitFile> read_bit(const std::string& path,
                                  const std::vector<std::string>& overrides) {
  return std::make_shared<BitFile>(bit::read_bit(path, bit::DirectionRule::hybrid,
                                                 bit::InsideRule::down, bit::Densities::as_given,
                                                 overrides));
}

template <class Item, class Get>
auto values_of(const std::vector<Item>& items, Get get) {
  std::vector<std::decay_t<decltype(get(items.front()))>> values;
  for (const Item& item : items) values.push_back(get(item));
  return values;
}

/// The columns of the cutter table, one array or list each.
py::dict cutters_of(const BitFile& read) {
  const std::vector<bit::Cutter>& all = read.bit.cutters;
  const auto numbers = [&all](double bit::Cutter::*member) {
    return array_of(values_of(all, [member](const bit::Cutter& c) { return c.*member; }));
  };
  using bit::Cutter;
  return py::dict(
      "id"_a = array_of(values_of(all, [](const Cutter& c) { return c.id; })),
      "blade"_a = array_of(values_of(all, [](const Cutter& c) { return c.blade; })),
      "zone"_a = values_of(all, [](const Cutter& c) { return c.zone; }),
      "diameter"_a = numbers(&Cutter::diameter), "tip_radius"_a = numbers(&Cutter::tip_radius),
      "azimuth"_a = numbers(&Cutter::azimuth), "tip_height"_a = numbers(&Cutter::tip_height),
      "profile_angle"_a = numbers(&Cutter::profile_angle),
      "back_rake"_a = numbers(&Cutter::back_rake), "side_rake"_a = numbers(&Cutter::side_rake),
      "chamfer"_a = numbers(&Cutter::chamfer), "chamfer_angle"_a = numbers(&Cutter::chamfer_angle),
      "land"_a = numbers(&Cutter::land), "land_angle"_a = numbers(&Cutter::land_angle),
      "length"_a = numbers(&Cutter::length),
      "table_thickness"_a = numbers(&Cutter::table_thickness), "wear"_a = numbers(&Cutter::wear),
      "under_exposure"_a = numbers(&Cutter::under_exposure));
}

/// The parts in the order of arrays by part.
py::dict parts_of(const BitFile& read) {
  const std::vector<bit::Part>& all = read.bit.parts;
  return py::dict(
      "name"_a = values_of(all, [](const bit::Part& p) { return p.name; }),
      "kind"_a = values_of(all, [](const bit::Part& p) { return bit::kind_name(p.kind); }),
      "cutting"_a = values_of(
          all, [](const bit::Part& p) { return bit::cutting_name(bit::final_cutting(p)); }),
      "cutter"_a = array_of(values_of(all, [](const bit::Part& p) { return p.cutter; })),
      "triangles"_a = array_of(values_of(
          all, [](const bit::Part& p) { return static_cast<int>(p.mesh_P.triangles.size()); })),
      "volume"_a = array_of(
          values_of(all, [](const bit::Part& p) { return mesh::enclosed_volume(p.mesh_P); })),
      "density"_a = array_of(values_of(all, [](const bit::Part& p) { return p.density; })));
}

/// Mass, centre and inertia tensor; None if a part has no density.
py::object mass_of(const BitFile& read) {
  if (!read.without_density.empty()) return py::none();
  const bit::MassProperties m = bit::mass_properties(read.bit);
  return py::make_tuple(m.mass, array_of(m.centre), array_of(m.inertia));
}

std::string analysis_of(const BitFile& read, double penetration, double speed,
                        const std::vector<double>& cone_speeds) {
  return bit::analysis_json(read.bit, {penetration, speed, cone_speeds});
}

/// The imbalances of the cutters at a penetration: unit law, its vector, planar model, and the area
/// that each cutter cuts.
py::dict imbalance_of(const BitFile& read, double penetration, double normal_ratio) {
  const std::vector<int> counted = bit::cutting_at_start(read.bit);
  const std::vector<bit::Cutter> cutters = bit::cutters_at(read.bit, counted);
  const bit::Engagement e = bit::engagement(cutters, penetration, bit::report_column_width);
  return py::dict("unit_law"_a = bit::imbalance(cutters, e.area),
                  "unit_law_vector"_a = array_of(bit::imbalance_vector(cutters, e.area)),
                  "planar"_a = bit::planar_imbalance(cutters, e.area, normal_ratio),
                  "mean_redundancy"_a = bit::mean_redundancy(e.cutting),
                  "areas"_a = array_of(bit::expand_to_all_cutters(read.bit, counted, e.area, 0.0)));
}

py::tuple bit_surface_of(const BitFile& read) {
  std::vector<int> parts;
  const mesh::TriangleMesh m = bit::merged_mesh(read.bit, Pose{}, &parts);
  return py::make_tuple(array_of(m.positions), array_of(m.triangles), array_of(parts));
}

py::tuple profile_of(const BitFile& read) {
  constexpr double spacing = 0.25e-3;
  const auto points = bit::exposure_profile(bit::swept_parts(read.bit), spacing);
  return py::make_tuple(
      array_of(values_of(points, [](const bit::ProfilePoint& p) { return p.r; })),
      array_of(values_of(points, [](const bit::ProfilePoint& p) { return p.z; })));
}

/// Writes the files of `tdbd bit -o FOLDER`. `unit`: of STL, OBJ and OFF files.
void export_bit(const BitFile& read, const std::string& folder, const std::string& format,
                const std::string& solids, const std::string& unit, bool force) {
  bit::ExportOptions formats{.parts = format, .solids = solids};
  try {
    formats.unit = mesh::length_unit(unit);
  } catch (const UnitError&) {
    throw py::value_error("unit: found '" + unit +
                          "', expected a length unit such as 'mm' or 'in'");
  }
  const py::gil_scoped_release released;
  const OutputFolder out = prepare(folder, overwrite_of(force), read.files, ResultKind::bit);
  bit::export_bit(out.path, read.bit, formats);
  bit::write_bit_files(out.path, read.bit);
  bit::write_profile(out.path, read.bit);
  bit::write_cutter_table(out.path, read.bit);
  bit::export_solids(out.path, read.bit, formats);
  bit::write_bit_vtp(out.path / "bit.vtp", read.bit, Pose{});
}

}  // namespace

void add_bits(py::module_& m) {
  using py::arg;
  using Free = py::call_guard<py::gil_scoped_release>;
  py::class_<BitFile, std::shared_ptr<BitFile>>(m, "BitFile")
      .def_property_readonly("name", [](const BitFile& f) { return f.bit.name; })
      .def_property_readonly("gage_radius", [](const BitFile& f) { return f.bit.gage_radius; })
      .def_property_readonly("cones", [](const BitFile& f) { return f.bit.cones.size(); })
      .def_readonly("files", &BitFile::files)
      .def_readonly("without_density", &BitFile::without_density);
  m.def("read_bit", &read_bit, arg("path"), arg("overrides"), Free());
  m.def("bit_cutters", &cutters_of, arg("bit"));
  m.def("bit_parts", &parts_of, arg("bit"));
  m.def("bit_mass", &mass_of, arg("bit"));
  m.def("bit_analysis", &analysis_of, arg("bit"), arg("penetration"), arg("speed"),
        arg("cone_speeds"), Free());
  m.def("bit_imbalance", &imbalance_of, arg("bit"), arg("penetration"), arg("normal_ratio"));
  m.def("bit_surface", &bit_surface_of, arg("bit"));
  m.def("bit_profile", &profile_of, arg("bit"));
  m.def("export_bit", &export_bit, arg("bit"), arg("folder"), arg("format"), arg("solids"),
        arg("unit"), arg("force"));
}

}  // namespace tdbd::python
