#include "bit/report/bit_report_parts.hpp"

#include <cmath>

#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone/meridian.hpp"
#include "bit/cutter/cutter_frame.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "bit/report/bit_output.hpp"
#include "bit/report/cone_report.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit {
namespace {

using Json = nlohmann::ordered_json;

constexpr double profile_spacing = 1e-3;  ///< m

/// A cone's meridian where the cone is deepest, in the bit's half-plane: the vertical plane through
/// the journal, turned about the bit's axis.
Json in_bit_half_plane(const Cone& cone, const Meridian& meridian) {
  const Vec3 s_B = -cone.X_BK.R.col(2);
  const Vec3 down_B = (Vec3::UnitZ() - s_B.z() * s_B).normalized();
  Json points = Json::array();
  for (const ShellPoint& p : meridian) {
    const Vec3 x_B = cone.X_BK.p + p.s * s_B + p.r * down_B;
    points.push_back({std::hypot(x_B.x(), x_B.y()), x_B.z()});
  }
  return points;
}

Json section_of(const Cone& cone, const std::string& part, const Meridian& meridian) {
  Json points = Json::array();
  for (const ShellPoint& p : meridian) points.push_back({p.s, p.r});
  return {{"part", part},
          {"meridian_sr_m", points},
          {"meridian_rz_m", in_bit_half_plane(cone, meridian)}};
}

Json sections_of(const Cone& cone) {
  Json all = Json::array({section_of(cone, "shell", shell_meridian(cone.layout.shell))});
  int number = 0;
  for (const ToothRow& row : cone.layout.rows)
    all.push_back(
        section_of(cone, "row-" + std::to_string(++number), row_meridian(cone.layout, row)));
  return all;
}

Json clearance_of(const Clearance& c) {
  return {{"part_a", c.part_a},       {"part_b", c.part_b},
          {"distance_m", c.distance}, {"angle_a_rad", c.angle_a},
          {"angle_b_rad", c.angle_b}, {"place_m", vector_json(c.place_B)}};
}

}  // namespace

Json vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json parts_json(const Bit& bit) {
  Json parts = Json::array();
  for (const Part& p : bit.parts)
    parts.push_back({{"name", p.name},
                     {"kind", kind_name(p.kind)},
                     {"cuts", p.cutting == Cutting::cuts},
                     {"cutter", p.cutter},
                     {"cone", p.cone},
                     {"volume_m3", mesh::enclosed_volume(p.mesh_P)},
                     {"density_kg_m3", p.density},
                     {"origin_m", vector_json(p.X_BP.p)},
                     {"update_direction", vector_json(p.update_direction_B)}});
  return parts;
}

void add_placing(const Cutter& c, Json& entry) {
  entry["diameter_m"] = c.diameter;
  entry["tip_m"] = vector_json(tip_B(c));
  entry["face_centre_m"] = vector_json(c.X_BC.p);
  entry["x_axis"] = vector_json(c.X_BC.R.col(0));
  entry["y_axis"] = vector_json(c.X_BC.R.col(1));
  entry["z_axis"] = vector_json(c.X_BC.R.col(2));
  entry["profile_normal"] = vector_json(profile_normal_B(c));
}

void add_body_profile(const Bit& bit, Json& file) {
  std::vector<Part> body;
  for (const Part& p : bit.parts)
    if (p.kind == PartKind::bit_body) body.push_back(p);
  if (body.empty() || !bit.cones.empty()) return;
  for (Part& p : body) p.cutting = Cutting::cuts;
  Json points = Json::array();
  for (const ProfilePoint& p : exposure_profile(body, profile_spacing))
    points.push_back({p.r, p.z});
  file["body_profile_rz_m"] = points;
}

void add_cones(const Bit& bit, Json& file) {
  file["cones"] = cones_json(bit);
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    file["cones"][k]["sections"] = sections_of(bit.cones[k]);
  file["clearances"] = Json::array();
  for (const Clearance& c : cone_clearances(bit.cones))
    file["clearances"].push_back(clearance_of(c));
}

}  // namespace tdbd::bit
