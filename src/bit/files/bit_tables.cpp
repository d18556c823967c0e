#include "bit/files/bit_tables.hpp"

#include "bit/areas/area_keys.hpp"
#include "bit/areas/bit_area_keys.hpp"
#include "bit/files/adjust_file.hpp"
#include "bit/files/cone_keys.hpp"
#include "bit/files/design_keys.hpp"
#include "bit/files/mesh_keys.hpp"
#include "bit/files/pdc_keys.hpp"

namespace tdbd::bit {
namespace {

template <class... Keys>
KeyTable bit_table(const TableKey& table, const Keys&... keys) {
  return key_table("bit", table, {row(keys)...});
}

KeyTable cutters() {
  using namespace cutter_keys;
  return bit_table(table, chamfer, chamfer_angle, length, table_thickness, land, land_angle);
}

KeyTable meshes() {
  using namespace cutter_mesh_keys;
  using namespace cone_mesh_keys;
  return bit_table({"mesh", "the meshes of cutters, or of cones and their teeth"}, grading,
                   rim_segments, uniform_edge, segments, facets);
}

KeyTable gage_pads() {
  using namespace gage_pad_keys;
  return bit_table(table, count, length, width, under_gage, thickness, behind);
}

KeyTable adjust() {
  using namespace adjust_keys;
  return bit_table(adjust_keys::table, azimuth, adjust_keys::back_rake, adjust_keys::side_rake,
                   along);
}

KeyTable blades() {
  using namespace blade_keys;
  return bit_table(table, exposure, slot_depth, width, wall, gage_length, neck, shank_radius,
                   shank_length, edge, density, rubs, cuts);
}

/// The keys of an area, except those of forces, which are in the case.
KeyTable areas() {
  namespace area = area_keys;
  return bit_table(bit_area_keys::table, area::kind, area::zone, area::blade, area::cone, area::row,
                   area::names, area::part, bit_area_keys::material, bit_area_keys::density,
                   bit_area_keys::cutting, bit_area_keys::share, bit_area_keys::from_depth,
                   bit_area_keys::from_time, bit_area_keys::from_wear, bit_area_keys::worn_names);
}

KeyTable profile() {
  using namespace profile_keys;
  return bit_table(table, cone_angle, nose_place, nose_radius, shoulder_angle,
                   profile_keys::shoulder_radius, gage_length);
}

KeyTable regions(const TableKey& table, const region_keys::Keys& keys) {
  return bit_table(table, keys.first, keys.nose, keys.shoulder, keys.gage);
}

/// [design] and the tables in it.
std::vector<KeyTable> design() {
  using namespace region_keys;
  return {bit_table(design_keys::table, design_keys::first_radius, design_keys::spiral,
                    design_keys::clearance),
          profile(),
          bit_table(design_blade_keys::table, design_blade_keys::azimuth, design_blade_keys::start,
                    design_blade_keys::backups),
          regions(diameter, diameters),
          regions(overlap, overlaps),
          regions(back_rake, back_rakes),
          regions(side_rake, side_rakes),
          regions(wear, wears),
          bit_table(backup_keys::table, backup_keys::from, backup_keys::to,
                    backup_keys::under_exposure, backup_keys::behind),
          bit_table(gage_row_keys::table, gage_row_keys::cutters, gage_row_keys::start,
                    gage_row_keys::spacing)};
}

KeyTable journals() {
  using namespace journal_keys;
  return bit_table(table, angle, offset, skew, apex, foot_height);
}

KeyTable teeth() {
  using namespace tooth_keys;
  return bit_table(table, kind, diameter, width, protrusion, crest_length, crest_width, tip_radius,
                   embedding, half_angle, density);
}

/// The keys of one cone. It may also contain those of the journal.
KeyTable cones() {
  using namespace bit_cone_keys;
  return bit_table(table, azimuth, journal_angle, journal_keys::offset, journal_keys::skew,
                   journal_keys::apex, journal_keys::foot_height, shell, density, body_cuts);
}

KeyTable tooth_rows() {
  using namespace tooth_row_keys;
  return bit_table(table, s, sink, lean, gage, angles, tooth_row_keys::teeth, first_angle, spacing);
}

KeyTable legs() {
  using namespace leg_keys;
  return bit_table(table, width, under_gage, clearance, tip_radius, shoulder, top, density, rubs,
                   inserts, insert_diameter, insert_length, insert_protrusion);
}

KeyTable shank() {
  using namespace shank_keys;
  return bit_table(table, radius, length, height, density);
}

KeyTable parts() {
  using namespace part_file_keys;
  return bit_table(table, name, kind, file, unit, cutting, rubs, density, group, position,
                   rotation_vector, part_file_keys::update_direction);
}

KeyTable solid_rules() {
  using namespace solid_rule_keys;
  return bit_table(table, match, name, kind, cutting, rubs, density, group, cutter_position,
                   cutter_rotation_vector, solid_rule_keys::update_direction);
}

KeyTable solid_cones() {
  using namespace solid_cone_keys;
  return bit_table(table, name, azimuth, journal_angle, offset, skew, apex, foot_height,
                   rolling_ratio);
}

}  // namespace

std::vector<KeyTable> bit_tables() {
  std::vector<KeyTable> all{bit_table(bit_file_keys::table, bit_file_keys::name,
                                      bit_file_keys::cutter_table, bit_file_keys::gage_diameter,
                                      bit_file_keys::unit_check, cone_bit_keys::interference),
                            cutters(),
                            meshes(),
                            gage_pads(),
                            adjust(),
                            blades()};
  for (KeyTable& table : design()) all.push_back(std::move(table));
  for (KeyTable& table :
       std::vector<KeyTable>{journals(), teeth(), cones(), tooth_rows(), shank(), legs(), parts(),
                             bit_table(solids_keys::table, solids_keys::file, solids_keys::unit),
                             solid_rules(), solid_cones(), areas()})
    all.push_back(std::move(table));
  return all;
}

}  // namespace tdbd::bit
