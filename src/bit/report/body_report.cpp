#include "bit/report/body_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bit/body/rubbing.hpp"
#include "bit/profile/engagement.hpp"
#include "bit/report/bit_output.hpp"

namespace tdbd::bit {
namespace {

/// The body of a bit with blades.
const Part& body_of(const Bit& bit) {
  return *std::ranges::find(bit.parts, PartKind::bit_body, &Part::kind);
}

Rubbing body_rubbing(const Bit& bit, double advance) {
  return rubbing(bit.cutters, body_of(bit), advance, report_column_width);
}

std::string place_text(const Vec3& x_B) {
  return fmt::format("radius {:.2f} mm, height {:.2f} mm", 1e3 * x_B.head<2>().norm(),
                     -1e3 * x_B.z());
}

}  // namespace

nlohmann::ordered_json body_json(const Bit& bit, double advance) {
  const Rubbing r = body_rubbing(bit, advance);
  const Cutting cutting = body_of(bit).cutting;
  return {{"exposure_m", bit.blades->exposure},
          {"slot_depth_m", bit.blades->slot_depth},
          {"junk_slot_area_m2", bit.blades->junk_slot_area},
          {"cuts", cutting == Cutting::cuts},
          {"rubs", cutting == Cutting::rubs},
          {"least_axial_clearance_m", r.clearance},
          {"least_axial_clearance_at_m", vector_json(r.clearance_at_B)},
          {"touches_at_m_per_rev", r.touching_advance},
          {"touches_first_at_m", vector_json(r.touching_at_B)},
          {"vertices_measured", r.vertices},
          {"vertices_over_uncut_rock", r.over_uncut}};
}

std::string body_text(const Bit& bit, double advance) {
  if (!bit.blades) return "";
  const Rubbing r = body_rubbing(bit, advance);
  return fmt::format(
      "blades: exposure {:.3f} mm, slots {:.3f} mm deep, junk slot area {:.1f} mm2\n"
      "rubbing: at {:.3f} mm per revolution the blades clear the rock by {:.3f} mm along the axis "
      "({})\n  they touch it from {:.3f} mm per revolution on ({})\n",
      1e3 * bit.blades->exposure, 1e3 * bit.blades->slot_depth, 1e6 * bit.blades->junk_slot_area,
      1e3 * advance, 1e3 * r.clearance, place_text(r.clearance_at_B), 1e3 * r.touching_advance,
      place_text(r.touching_at_B));
}

}  // namespace tdbd::bit
