#include "bit/pdc/pdc_bit.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "bit/body/bit_body.hpp"
#include "bit/body/blade_body.hpp"
#include "bit/cutter/cutter_frame.hpp"
#include "core/error.hpp"

namespace tdbd::bit {
namespace {

void append(std::vector<Part>& parts, std::vector<Part> more) {
  for (Part& part : more) parts.push_back(std::move(part));
}

std::vector<Part> indexed_cutter_parts(const Cutter& c, int index, const PdcOptions& options) {
  std::vector<Part> parts = cutter_parts(c, options.meshing);
  for (Part& part : parts) {
    part.update_direction_B = update_direction(c.X_BC, options.directions, options.inside);
    part.group = index;
    part.cutter = index;
  }
  return parts;
}

void add_body(const PdcOptions& options, Bit& bit) {
  if (!options.blades) {
    bit.parts.push_back(
        bit_body(bit.cutters, options.body_setback, options.body_density, bit.gage_radius));
    return;
  }
  const BladeOptions& blades = *options.blades;
  std::string lines;
  for (const BladeProblem& p : blade_problems(bit.cutters, blades, bit.gage_radius))
    lines += fmt::format("{}{}: blades.{}: found {}, expected {}", lines.empty() ? "" : "\n",
                         bit.name, p.key, p.found, p.expected);
  if (!lines.empty()) throw InputError(lines);
  bit.parts.push_back(blade_body(bit.cutters, blades, bit.gage_radius));
  bit.blades = {blades.exposure, blades.slot_depth,
                junk_slot_area(blade_shape(bit.cutters, blades), blades, bit.gage_radius)};
}

}  // namespace

Bit pdc_bit(std::string name, std::vector<Cutter> cutters, const PdcOptions& options) {
  if (cutters.empty()) throw InputError(name + ": found no cutter, expected at least one");
  Bit bit;
  bit.name = std::move(name);
  bit.cutters = std::move(cutters);
  for (int i = 0; i < static_cast<int>(bit.cutters.size()); ++i) {
    bit.cutters[i].X_BC = cutter_pose(bit.cutters[i]);
    append(bit.parts, indexed_cutter_parts(bit.cutters[i], i, options));
  }
  bit.gage_radius = largest_radius(bit.parts);
  append(bit.parts, gage_pads(options.pads, bit.cutters, bit.gage_radius));
  add_body(options, bit);
  return bit;
}

}  // namespace tdbd::bit
