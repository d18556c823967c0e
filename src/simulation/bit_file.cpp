#include "simulation/bit_file.hpp"

#include <utility>

#include "bit/cutter_table.hpp"
#include "bit/largest_radius.hpp"
#include "bit/pdc_bit.hpp"
#include "core/config.hpp"
#include "simulation/bit_parts.hpp"

namespace tdbd::simulation {
namespace {

bit::CutterDefaults read_defaults(Config c) {
  bit::CutterDefaults d;
  d.chamfer = c.quantity("chamfer", "m", 0.0, Range::non_negative());
  d.chamfer_angle = c.quantity("chamfer_angle", "rad", d.chamfer_angle, Range::within(0.05, 1.5));
  d.length = c.quantity("length", "m", d.length, Range::positive());
  d.table_thickness = c.quantity("table_thickness", "m", d.table_thickness, Range::positive());
  return d;
}

bit::CutterMeshing read_meshing(Config c) {
  bit::CutterMeshing m;
  m.grading = c.choice<bit::Grading>(
      "grading", {{"graded", bit::Grading::graded}, {"uniform", bit::Grading::uniform}}, m.grading);
  m.rim_segments = static_cast<int>(c.integer("rim_segments", m.rim_segments, 8, 4096));
  m.uniform_edge = c.quantity("uniform_edge", "m", m.uniform_edge, Range::positive());
  return m;
}

bit::GagePads read_pads(Config c) {
  bit::GagePads p;
  p.count = static_cast<int>(c.integer("count", 0, 0, 64));
  p.length = c.quantity("length", "m", p.length, Range::positive());
  p.width = c.quantity("width", "m", p.width, Range::positive());
  p.under_gage = c.quantity("under_gage", "m", p.under_gage, Range::non_negative());
  p.thickness = c.quantity("thickness", "m", p.thickness, Range::positive());
  return p;
}

bit::Bit read_pdc_bit(Config& c, const std::string& name, bit::DirectionRule directions,
                      bit::InsideRule inside) {
  const std::string table = c.path("table", std::nullopt);
  const bit::CutterDefaults defaults = read_defaults(c.table("cutters"));
  bit::PdcOptions options;
  options.meshing = read_meshing(c.table("mesh"));
  options.pads = read_pads(c.table("gage_pads"));
  options.directions = directions;
  options.inside = inside;
  c.finish();
  return bit::pdc_bit(name, bit::read_cutter_table(table, defaults), options);
}

bit::Bit read_mesh_bit(Config& c, const std::string& name, bit::DirectionRule directions,
                       bit::InsideRule inside) {
  bit::Bit bit;
  bit.name = name;
  PartsFromFiles read = read_parts(c, directions, inside);
  c.finish();
  direct_by_profile(read, directions, inside);
  bit.parts = std::move(read.parts);
  bit.gage_radius = bit::largest_radius(bit.parts);
  return bit;
}

}  // namespace

bit::Bit read_bit(const std::string& path, bit::DirectionRule directions, bit::InsideRule inside) {
  Config c = Config::read_file(path, {});
  const std::string name = c.text("name", std::nullopt);
  if (c.has("parts") && c.has("table")) c.problem("table", "parts as well", "one of the two");
  return c.has("parts") ? read_mesh_bit(c, name, directions, inside)
                        : read_pdc_bit(c, name, directions, inside);
}

}  // namespace tdbd::simulation
