#include "bit/files/solid_cones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/files/mesh_keys.hpp"
#include "core/config/toml_text.hpp"

namespace tdbd::bit {

std::vector<Cone> read_solid_cones(Config& solids) {
  std::vector<Cone> cones;
  for (Config& c : solids.tables(solid_cone_keys::table)) {
    Cone cone;
    cone.name = c.read(solid_cone_keys::name);
    cone.layout.azimuth = c.read(solid_cone_keys::azimuth);
    cone.layout.journal_angle = c.read(solid_cone_keys::journal_angle);
    cone.layout.offset = c.read(solid_cone_keys::offset);
    cone.layout.skew = c.read(solid_cone_keys::skew);
    cone.layout.apex = c.read(solid_cone_keys::apex);
    cone.layout.foot_height = c.read(solid_cone_keys::foot_height);
    cone.rolling_ratio = c.read(solid_cone_keys::rolling_ratio);
    cone.X_BK = cone_pose(cone.layout, 0.0);
    cones.push_back(cone);
  }
  return cones;
}

int cone_of(const std::vector<Cone>& cones, const std::string& part) {
  const auto at = std::find_if(cones.begin(), cones.end(),
                               [&](const Cone& cone) { return part.starts_with(cone.name + "/"); });
  return at == cones.end() ? -1 : static_cast<int>(at - cones.begin());
}

std::string cone_text_of(const Cone& cone) {
  const ConeLayout& c = cone.layout;
  return fmt::format(
      "\n[[solids.cones]]\nname = {}\nazimuth = {}  # rad\njournal_angle = {}  # rad\noffset = {}  "
      "# m\nskew = {}  # rad\napex = {}  # m\nfoot_height = {}  # m\nrolling_ratio = {}\n",
      toml_string(cone.name), c.azimuth, c.journal_angle, c.offset, c.skew, c.apex, c.foot_height,
      rolling_ratio_of_gage_row(cone));
}

}  // namespace tdbd::bit
