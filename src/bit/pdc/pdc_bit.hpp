#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/body/blade_shape.hpp"
#include "bit/cutter/cutter_parts.hpp"
#include "bit/pdc/gage_pads.hpp"
#include "bit/update_direction.hpp"

namespace tdbd::bit {

/// Options that the cutter table does not determine.
struct PdcOptions {
  CutterMeshing meshing;
  DirectionRule directions = DirectionRule::hybrid;
  InsideRule inside = InsideRule::down;
  GagePads pads;
  double body_density = 7850.0;        ///< kg/m3
  double body_setback = 0.4;           ///< times a cutter's diameter, from its tip into the body
  std::optional<BladeOptions> blades;  ///< if given: blades instead of a solid of revolution
};

/// Makes a fixed-cutter bit from its table: the parts of each cutter in the table's order (group
/// and cutter: its index), then the gage pads, then the body, a solid of revolution (bit_body.hpp)
/// or blades and junk slots (blade_body.hpp). The gage radius is the largest radius of a cutter's
/// vertex. Throws InputError without cutters and for impossible blades (blade_problems). Thesis:
/// 3.1, 3.2.2.
Bit pdc_bit(std::string name, std::vector<Cutter> cutters, const PdcOptions& options);

}  // namespace tdbd::bit
