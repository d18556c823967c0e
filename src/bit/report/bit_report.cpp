#include "bit/report/bit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "bit/body/bit_body.hpp"
#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "bit/report/bit_facts.hpp"
#include "bit/report/bit_output.hpp"
#include "bit/report/body_report.hpp"
#include "bit/report/cone_report.hpp"
#include "io/whole_file.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit {
namespace {

double total(const std::vector<CutterOverlap>& overlaps) {
  double volume = 0.0;
  for (const CutterOverlap& o : overlaps) volume += o.volume;
  return volume;
}

int id_of(const Bit& bit, int cutter) { return bit.cutters[static_cast<std::size_t>(cutter)].id; }

}  // namespace

nlohmann::ordered_json overlaps_json(const Bit& bit, const std::vector<CutterOverlap>& overlaps) {
  nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
  for (const CutterOverlap& o : overlaps)
    pairs.push_back({{"a", fmt::format("cutter-{}", id_of(bit, o.a))},
                     {"b", fmt::format("cutter-{}", id_of(bit, o.b))},
                     {"volume_m3", o.volume}});
  return {{"volume_m3", total(overlaps)}, {"pairs", pairs}};
}

std::string overlaps_text(const Bit& bit, const std::vector<CutterOverlap>& overlaps) {
  if (overlaps.empty()) return "";
  const CutterOverlap& worst = std::ranges::max(overlaps, {}, &CutterOverlap::volume);
  const std::string pair =
      fmt::format("cutters {} and {}", id_of(bit, worst.a), id_of(bit, worst.b));
  if (overlaps.size() == 1)
    return fmt::format("warning: {} overlap by {:.1f} mm3, which the mass counts twice\n", pair,
                       1e9 * worst.volume);
  return fmt::format(
      "warning: {} pairs of cutters overlap by {:.1f} mm3, which the mass counts twice; the "
      "largest "
      "overlap is {:.1f} mm3, {}\n",
      overlaps.size(), 1e9 * total(overlaps), 1e9 * worst.volume, pair);
}

std::string enclosed_text(const Bit& bit) {
  std::string text;
  for (const auto& [inner, outer] : enclosed_parts(bit))
    text += fmt::format("warning: {} lies inside {}, so its volume counts twice in the mass\n",
                        bit.parts[static_cast<std::size_t>(inner)].name,
                        bit.parts[static_cast<std::size_t>(outer)].name);
  return text;
}

namespace {

using Json = nlohmann::ordered_json;

constexpr int outline_points = 72;

Json outline_of(const Cutter& c) {
  Json points = Json::array();
  for (const Vec3& p : turned_outline(c, outline_points)) points.push_back({p.x(), p.z()});
  return points;
}

Json cutter_of(const Cutter& c, double overlap, double area, double volume) {
  return {{"name", "cutter-" + std::to_string(c.id)},
          {"blade", c.blade},
          {"zone", c.zone},
          {"tip_radius_m", c.tip_radius},
          {"tip_height_m", c.tip_height},
          {"azimuth_rad", c.azimuth},
          {"profile_angle_rad", c.profile_angle},
          {"back_rake_rad", c.back_rake},
          {"side_rake_rad", c.side_rake},
          {"under_exposure_m", c.under_exposure},
          {"wear_m", c.wear},
          {"overlap_with_next", std::isnan(overlap) ? Json() : Json(overlap)},
          {"area_m2", area},
          {"volume_m3_per_rev", volume},
          {"outline_rz_m", outline_of(c)}};
}

Json inertia_of(const Mat3& inertia) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back({inertia(i, 0), inertia(i, 1), inertia(i, 2)});
  return rows;
}

/// The placement of a cutter in the bit frame: tip, centre of the face, axes of its frame (thesis:
/// 3.2.2) and the profile's normal.
void add_placing(const Cutter& c, Json& entry) {
  entry["diameter_m"] = c.diameter;
  entry["tip_m"] = vector_json(tip_B(c));
  entry["face_centre_m"] = vector_json(c.X_BC.p);
  entry["x_axis"] = vector_json(c.X_BC.R.col(0));
  entry["y_axis"] = vector_json(c.X_BC.R.col(1));
  entry["z_axis"] = vector_json(c.X_BC.R.col(2));
  entry["profile_normal"] = vector_json(profile_normal_B(c));
}

/// Values of the counted cutters. The others cut nothing, and their overlap and exposure are not
/// known.
Json cutters_json(const Bit& bit, const std::vector<int>& counted,
                  const std::vector<Cutter>& cutting, const Engagement& e) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> overlap =
                                expand_to_all_cutters(bit, counted, overlaps(cutting), unknown),
                            exposure =
                                expand_to_all_cutters(bit, counted, exposures(cutting), unknown),
                            area = expand_to_all_cutters(bit, counted, e.area, 0.0),
                            volume = expand_to_all_cutters(bit, counted, e.volume, 0.0);
  Json cutters = Json::array();
  for (std::size_t k = 0; k < bit.cutters.size(); ++k) {
    cutters.push_back(cutter_of(bit.cutters[k], overlap[k], area[k], volume[k]));
    if (!std::ranges::binary_search(counted, static_cast<int>(k)))
      cutters.back()["counted"] = false;
    cutters.back()["exposure_m"] = exposure[k];
    add_placing(bit.cutters[k], cutters.back());
  }
  return cutters;
}

using Json = nlohmann::ordered_json;

constexpr double profile_spacing = 1e-3;  ///< m

/// A cone's meridian at the angle at which the cone is deepest, in the bit's half-plane: the
/// vertical plane through the journal, rotated about the bit's axis.
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

Json clearance_of(const LegClearance& c) {
  return {{"leg", c.leg},
          {"part", c.part},
          {"distance_m", c.distance},
          {"angle_rad", c.angle},
          {"place_m", vector_json(c.place_B)}};
}

/// Every part, in the order of the part numbers in bit.vtp.
Json parts_json(const Bit& bit) {
  Json parts = Json::array();
  for (const Part& p : bit.parts)
    parts.push_back({{"name", p.name},
                     {"kind", kind_name(p.kind)},
                     {"cuts", final_cutting(p) == Cutting::cuts},
                     {"cutter", p.cutter},
                     {"cone", p.cone},
                     {"volume_m3", mesh::enclosed_volume(p.mesh_P)},
                     {"density_kg_m3", p.density},
                     {"origin_m", vector_json(p.X_BP.p)},
                     {"update_direction", vector_json(p.update_direction_B)}});
  return parts;
}

/// The envelope of the body's parts when rotated into one half-plane. Absent if the bit has no
/// body, or has cones, because then the body is a shank.
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

/// The cones, each with the meridians of its shell and of the volumes swept by its rows, and the
/// clearances between cones and from legs.
void add_cones(const Bit& bit, Json& file) {
  file["cones"] = cones_json(bit);
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    file["cones"][k]["sections"] = sections_of(bit.cones[k]);
  file["clearances"] = Json::array();
  for (const Clearance& c : cone_clearances(bit.cones))
    file["clearances"].push_back(clearance_of(c));
  file["leg_clearances"] = Json::array();
  for (const LegClearance& c : leg_clearances(bit))
    file["leg_clearances"].push_back(clearance_of(c));
}

}  // namespace

std::string analysis_json(const Bit& bit, const ReportOptions& options) {
  const std::vector<int> counted = cutting_at_start(bit);
  const std::vector<Cutter> cutting = cutters_at(bit, counted);
  const Engagement e = engagement(cutting, options.advance, report_column_width);
  const MassProperties mass = mass_properties(bit);
  Json file{{"schema", 1},
            {"name", bit.name},
            {"gage_radius_m", bit.gage_radius},
            {"penetration_m_per_rev", options.advance},
            {"imbalance_of_unit_law", imbalance(cutting, e.area)},
            {"imbalance_vector_of_unit_law", vector_json(imbalance_vector(cutting, e.area))},
            {"balance", balance_json(cutting, e)},
            {"mean_redundancy", mean_redundancy(e.cutting)},
            {"mass_kg", mass.mass},
            {"centre_m", vector_json(mass.centre)},
            {"inertia_kg_m2", inertia_of(mass.inertia)},
            {"column_width_m", e.column_width},
            {"cutters_cutting_at_radius", e.cutting},
            {"cutters", cutters_json(bit, counted, cutting, e)},
            {"parts", parts_json(bit)},
            {"properties", properties_json(bit, {})}};
  add_body_profile(bit, file);
  if (!bit.cones.empty()) {
    add_cones(bit, file);
    add_tracking(bit, cone_operation(bit, options.cone_speeds, options.advance), file);
    add_assumptions(bit, options.bit_speed, file);
  }
  file["cutter_overlaps"] = overlaps_json(bit, cutter_overlaps(bit));
  if (!bit.cutters.empty()) file["cutters_in_body_m3"] = cutters_in_body(bit);
  if (bit.blades) file["body"] = body_json(bit, options.advance);
  return file.dump(1) + "\n";
}

void write_analysis(const std::filesystem::path& folder, const Bit& bit,
                    const ReportOptions& options) {
  write_text(folder / "analysis.json", analysis_json(bit, options));
}

}  // namespace tdbd::bit
