#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/body/blade_shape.hpp"
#include "bit/cutter/cutter.hpp"

namespace tdbd::bit {

/// Equal pads around the gage. The middle of the first one is behind the highest cutter.
struct GagePads {
  int count = 0;
  double length = 0.05;          ///< m, along the axis
  double width = 0.03;           ///< m, along the circumference
  double under_gage = 0.4e-3;    ///< m, distance inside the gage radius
  double thickness = 0.01;       ///< m, radial, in the middle
  double behind = 0.0;           ///< m, along the circumference, from the cutter to a pad's middle
  std::optional<double> height;  ///< m, lower end above the nose tip; default: highest cutter's top
};

/// A mistake of the pads: the key in the bit file, its value, and what is expected.
struct PadProblem {
  std::string key;
  std::string found;
  std::string expected;
};

/// Returns what makes pads impossible on this gage radius (m): a pad that lies across the axis,
/// whose back is outside its arc, or that overlaps the next one. Empty without pads.
std::vector<PadProblem> pad_problems(const GagePads& pads, double gage_radius);

/// Makes the parts gage-pad-1, gage-pad-2, ...: closed convex boxes whose outer side follows the
/// cylinder of radius gage_radius - under_gage (inscribed) and whose inner side is flat. A pad's
/// frame is the bit's, rotated to the pad's azimuth. Pads move rock along their X axis, outwards.
/// Thesis: 3.1.
std::vector<Part> gage_pads(const GagePads& pads, const std::vector<Cutter>& cutters,
                            double gage_radius);

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
