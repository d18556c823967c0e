#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/files/bit_file.hpp"
#include "bit/generate.hpp"
#include "bit/wear/wear.hpp"
#include "core/error.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"
#include "reference/literature/drag/wear/glowka_wear.hpp"

namespace tdbd::bit::worn_bit_test {

/// Relative, of the volume that a mesh lost to the worn volume.
constexpr double wear_ledger = 1e-12;

/// A bit of one cutter, perhaps worn and with chamfers.
Bit any_bit() {
  Cutter c = any_cutter();
  if (*rc::gen::arbitrary<bool>()) c.wear = number(1e-5, 0.1 * c.diameter);
  PdcOptions options;
  options.pads.count = 0;
  return pdc_bit("any", {c}, options);
}

/// A bit whose pieces lost these volumes (m3), and the flats.
struct WornBit {
  Bit bit;
  std::vector<WearFlat> flats;
};

WornBit worn_bit(const Bit& fresh, const std::vector<WearSolid>& solids,
                 const std::vector<double>& volumes) {
  WornBit worn{fresh, {}};
  for (std::size_t i = 0; i < solids.size(); ++i) {
    worn.flats.push_back(flat_of_volume(solids[i], volumes[i], solids[i].start).value());
    if (worn.flats[i].height > solids[i].start)
      wear_piece(fresh, solids[i], worn.flats[i].height, worn.bit);
  }
  return worn;
}

WornBit worn_bit(const Bit& fresh, const std::vector<double>& volumes) {
  return worn_bit(fresh, wear_solids(fresh), volumes);
}

/// What a cutter's meshes lost between two bits: the volumes of what of the old meshes is beyond the
/// flat of the new ones. Shares no function with flat_at.
double lost_by_mesh(const Bit& fresh, const WornBit& worn, int cutter) {
  const Cutter& c = worn.bit.cutters[static_cast<std::size_t>(cutter)];
  const Vec3 n_C = c.X_BC.R.transpose() * profile_normal_B(c);
  const double limit = n_C.dot(tip_C(c)) - worn.flats[static_cast<std::size_t>(cutter)].height;
  double lost = 0.0;
  for (const Part& part : fresh.parts) {
    if (part.cutter != cutter || (part.kind == PartKind::face && c.chamfer > 0.0)) continue;
    const mesh::TriangleMesh piece = mesh::clipped_convex(part.mesh_P, -n_C, -limit);
    if (!piece.triangles.empty()) lost += mesh::enclosed_volume(piece);
  }
  return lost;
}

/// The volumes of the meshes themselves, whose difference is exact to the rounding of a whole cutter.
double volume_of_cutter(const Bit& bit, int cutter) {
  const Cutter& c = bit.cutters[static_cast<std::size_t>(cutter)];
  double volume = 0.0;
  for (const Part& part : bit.parts)
    if (part.cutter == cutter && (part.kind != PartKind::face || c.chamfer == 0.0))
      volume += mesh::enclosed_volume(part.mesh_P);
  return volume;
}

RC_GTEST_PROP(WornBit, its_meshes_lost_the_worn_volume, ()) {
  const Bit fresh = any_bit();
  const WearSolid solid = wear_solids(fresh).front();
  const double height = solid.start + number(0.002, 0.95) * (solid.largest - solid.start);
  const double volume = flat_at(solid, height).volume * number(0.9, 1.0);
  const WornBit worn = worn_bit(fresh, {volume});
  RC_ASSERT(std::abs(lost_by_mesh(fresh, worn, 0) - volume) <= wear_ledger * volume);
  const double whole = volume_of_cutter(fresh, 0);
  RC_ASSERT(std::abs(whole - volume_of_cutter(worn.bit, 0) - volume) <= 1e-14 * whole);
}

RC_GTEST_PROP(WornBit, is_inside_the_fresh_one, ()) {
  const Bit fresh = any_bit();
  const WearSolid solid = wear_solids(fresh).front();
  const double volume = number(0.001, 0.9) * flat_at(solid, solid.largest).volume;
  const WornBit less = worn_bit(fresh, {volume}), more = worn_bit(fresh, {1.1 * volume});
  RC_ASSERT(more.flats[0].height > less.flats[0].height);
  const Bit& worn = less.bit;
  for (std::size_t p = 0; p < fresh.parts.size(); ++p) {
    const mesh::TriangleMesh &old = fresh.parts[p].mesh_P, &now = worn.parts[p].mesh_P;
    for (const mesh::Triangle& t : old.triangles) {
      const Vec3 &a = old.positions[t[0]], &b = old.positions[t[1]], &c = old.positions[t[2]];
      const Vec3 n = mesh::area_vector(a, b, c);
      if (fresh.parts[p].cutter < 0) continue;
      for (const Vec3& x : now.positions) RC_ASSERT(n.dot(x - a) < 1e-12 * n.norm() + 1e-18);
    }
    if (fresh.parts[p].cutter < 0) RC_ASSERT(now.positions == old.positions);
  }
}

RC_GTEST_PROP(WornBit, the_area_of_a_flat_is_the_slope_of_its_volume, ()) {
  const Bit fresh = any_bit();
  const WearSolid solid = wear_solids(fresh).front();
  const double height = solid.start + number(0.05, 0.9) * (solid.largest - solid.start);
  const double step = 1e-4 * (height - solid.start);
  const double slope =
      (flat_at(solid, height + step).volume - flat_at(solid, height - step).volume) / (2.0 * step);
  RC_ASSERT(std::abs(flat_at(solid, height).area - slope) <= 2e-4 * slope);
}

/// A sharp cylinder without side rake, long enough: inscribed polygons approach its wedge with the
/// square of the edge. Two meshes give the order.
TEST(WornBit, a_sharp_cutter_approaches_the_flat_of_the_reference_with_order_2) {
  Cutter c = table('b').front();
  c.chamfer = c.side_rake = 0.0;
  c.back_rake = 20.0 * degree;
  const double height = 1.5e-3, on_face = height / std::cos(c.back_rake);
  const reference::GlowkaFace face{0.5 * c.diameter, c.back_rake};
  const auto flat_of = [&](int rim) {
    PdcOptions options;
    options.meshing.rim_segments = rim;
    return flat_at(wear_solids(pdc_bit("one", {c}, options)).front(), height);
  };
  const double volume = reference::worn_volume(face, on_face),
               area = reference::flat_area(face, on_face);
  const auto error = [&](int rim) { return volume - flat_of(rim).volume; };
  EXPECT_NEAR(std::log2(error(128) / error(512)) / 2.0, 2.0, 0.1);
  const WearFlat flat = flat_of(1024);
  EXPECT_NEAR(flat.volume / volume, 1.0, 1e-4);
  EXPECT_NEAR(flat.area / area, 1.0, 1e-4);
  EXPECT_NEAR(flat.length / reference::flat_length(face, on_face), 1.0, 1e-4);
  const double width = 2.0 * std::sqrt(on_face * (c.diameter - on_face));
  EXPECT_NEAR(flat.width / width, 1.0, 1e-4);
}

TEST(WornBit, weighs_less_by_what_its_parts_lost) {
  const Bit fresh = example_bit('b');
  std::vector<double> volumes(fresh.cutters.size(), 0.0);
  volumes[2] = 2e-8;
  volumes[7] = 5e-9;
  const Bit worn = worn_bit(fresh, volumes).bit;
  double lost = 0.0;
  for (std::size_t p = 0; p < fresh.parts.size(); ++p)
    lost += fresh.parts[p].density * (mesh::enclosed_volume(fresh.parts[p].mesh_P) -
                                      mesh::enclosed_volume(worn.parts[p].mesh_P));
  const double mass = mass_properties(fresh).mass;
  EXPECT_GT(lost, 3500.0 * 2.5e-8);
  EXPECT_LT(lost, 14500.0 * 2.5e-8);
  EXPECT_NEAR(mass - mass_properties(worn).mass, lost, 1e-14 * mass);
  EXPECT_EQ(worn.gage_radius, fresh.gage_radius);
}

TEST(WornBit, without_worn_volume_is_the_fresh_one) {
  const Bit fresh = example_bit('b');
  const WornBit worn = worn_bit(fresh, std::vector<double>(fresh.cutters.size(), 0.0));
  for (std::size_t p = 0; p < fresh.parts.size(); ++p)
    EXPECT_EQ(worn.bit.parts[p].mesh_P.positions, fresh.parts[p].mesh_P.positions);
  for (std::size_t i = 0; i < fresh.cutters.size(); ++i)
    EXPECT_EQ(worn.bit.cutters[i].wear, fresh.cutters[i].wear);
}

TEST(WornBit, ends_where_a_flat_is_as_large_as_its_cutter) {
  const Bit fresh = example_bit('b');
  const WearSolid solid = wear_solids(fresh)[3];
  const double most = flat_at(solid, solid.largest).volume;
  EXPECT_TRUE(flat_of_volume(solid, std::nextafter(most, 0.0), 0.0));
  EXPECT_FALSE(flat_of_volume(solid, most, 0.0));
}

TEST(WornBit, has_the_dull_grades_of_its_worn_shares) {
  const Bit bit = example_bit('b');
  const std::vector<WearSolid> solids = wear_solids(bit);
  const auto grade = [&](double inner, double outer) {
    std::vector<double> heights;
    for (const Cutter& c : bit.cutters) {
      const bool is_inner = c.tip_radius <= bit.gage_radius * 2.0 / 3.0;
      heights.push_back((is_inner ? inner : outer) * c.diameter * std::cos(c.back_rake));
    }
    return dull_grade(bit, solids, heights);
  };
  EXPECT_EQ(grade(0.0, 0.0).inner, 0);
  EXPECT_EQ(grade(0.0, 0.0).outer, 0);
  EXPECT_EQ(grade(0.31, 0.44).inner, 2);  // 2.48 eighths
  EXPECT_EQ(grade(0.31, 0.44).outer, 4);  // 3.52 eighths: a cutter of the other group changes each
  EXPECT_EQ(grade(0.31, 2.0).outer, 8);
}

Bit shipped(const std::string& name) {
  return read_bit(TDBD_SOURCE_DIR "/cases/bits/" + name + ".toml", DirectionRule::hybrid,
                  InsideRule::down)
      .bit;
}

std::vector<std::uint8_t> all_parts(const Bit& bit) {
  return std::vector<std::uint8_t>(bit.parts.size(), 1);
}

/// A milled tooth is a wedge with plane sides from base to crest: areas of its sections are quadratic in
/// the height, so that the volume of its blunted tip follows from its crest and its base alone.
TEST(WornTooth, loses_the_volume_of_the_tip_of_a_wedge) {
  const Bit bit = shipped("bit-m");
  const std::vector<WearSolid> solids = wear_solids(bit, all_parts(bit));
  const auto is_tooth = [](const Part& part) { return part.kind == PartKind::tooth; };
  ASSERT_EQ(static_cast<std::ptrdiff_t>(solids.size()), std::ranges::count_if(bit.parts, is_tooth));
  for (const WearSolid& s : {solids.front(), solids[20], solids.back()}) {
    const Part& part = bit.parts[static_cast<std::size_t>(s.parts.front())];
    const ToothShape& shape = bit.cones[static_cast<std::size_t>(part.cone)]
                                  .layout.rows[static_cast<std::size_t>(part.row)]
                                  .shape;
    const double h = 0.4 * shape.protrusion;
    const double length = shape.crest_length, width = shape.crest_width;
    const double longer = (shape.diameter - length) / shape.protrusion,
                 wider = (shape.width - width) / shape.protrusion;
    const double volume = length * width * h + (length * wider + width * longer) * h * h / 2.0 +
                          longer * wider * h * h * h / 3.0;
    EXPECT_NEAR(flat_at(s, h).volume / volume, 1.0, 1e-12) << s.name;
    EXPECT_NEAR(flat_at(s, h).area / ((length + longer * h) * (width + wider * h)), 1.0, 1e-12);
    EXPECT_EQ(s.size, shape.protrusion);
  }
}

/// Teeth of every kind and gage pads: the ledger of the meshes, and the parts stay closed and convex.
TEST(WornTooth, and_worn_pads_lose_what_their_meshes_lose) {
  for (const char* name : {"bit-m", "bit-r", "bit-b"}) {
    const Bit bit = shipped(name);
    const std::vector<WearSolid> solids = wear_solids(bit, all_parts(bit));
    std::vector<double> volumes;
    for (std::size_t i = 0; i < solids.size(); ++i)
      volumes.push_back((0.1 + 0.8 * static_cast<double>(i) / static_cast<double>(solids.size())) *
                        flat_at(solids[i], solids[i].largest).volume);
    const WornBit worn = worn_bit(bit, solids, volumes);
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const LostVolume lost = lost_volume(bit, worn.bit, solids[i], worn.flats[i].height);
      EXPECT_NEAR(lost.beyond_flat / volumes[i], 1.0, wear_ledger) << solids[i].name;
      EXPECT_NEAR(lost.by_meshes, volumes[i], 1e-13 * lost.whole) << solids[i].name;
      for (const int p : solids[i].parts)
        EXPECT_TRUE(mesh::check_closed(worn.bit.parts[static_cast<std::size_t>(p)].mesh_P).empty());
    }
  }
}

TEST(WornTooth, counts_for_the_dull_grade_of_its_row) {
  const Bit bit = shipped("bit-m");
  const std::vector<WearSolid> solids = wear_solids(bit, all_parts(bit));
  std::vector<double> heights;
  for (const WearSolid& s : solids) {
    const Part& part = bit.parts[static_cast<std::size_t>(s.parts.front())];
    const Cone& cone = bit.cones[static_cast<std::size_t>(part.cone)];
    const double radius =
        row_measures(cone, cone.layout.rows[static_cast<std::size_t>(part.row)]).bit_radius;
    heights.push_back((radius > bit.gage_radius * 2.0 / 3.0 ? 0.9 : 0.3) * s.size);
  }
  const DullGrade grade = dull_grade(bit, solids, heights);
  EXPECT_EQ(grade.inner, 2);  // 2.4 eighths
  EXPECT_EQ(grade.outer, 7);  // 7.2 eighths
}

constexpr double ice = 273.15;  // K

/// Relative. Both programs round a few operations and one exponential of an argument up to 20.
constexpr double rounding = 1e-14;

/// Sliding wear of k = 1e-4 and H = 50 GPa, under 800 N at 0.5 m/s, by independent
/// calculation: 1e-4/50e9 * 800 * 0.5 = 8e-13 m3/s.
TEST(BitWearLaw, sliding_wear_has_the_rate_of_archard) {
  const WearLaw law = SlidingWear{.coefficient = 1e-4, .hardness = 50e9};
  EXPECT_NEAR(wear_rate(law, {800.0, 0.5, 900.0}), 8e-13, rounding * 8e-13);
  EXPECT_EQ(wear_rate(law, {0.0, 0.5, 900.0}), 0.0);
  EXPECT_EQ(wear_rate(law, {800.0, 0.0, 900.0}), 0.0);
  EXPECT_EQ(wear_rate(NoWear{}, {800.0, 0.5, 900.0}), 0.0);
}

RC_GTEST_PROP(BitWearLaw, thermal_wear_is_that_of_the_reference, ()) {
  const double k = number(1e-6, 1e-3), hardness = number(1e9, 1e11);
  const double threshold = number(500.0, 900.0), growth = number(20.0, 100.0);
  const double temperature = number(280.0, 1300.0);
  const reference::WearLaw expected{k / hardness, threshold, growth};
  const WearLaw law = ThermalWear{{k, hardness}, threshold, growth};
  const double c = reference::wear_coefficient(expected, temperature);
  RC_ASSERT(std::abs(wear_coefficient(law, temperature) - c) <= rounding * c);
}

RC_GTEST_PROP(BitWearLaw, the_temperature_of_a_flat_is_that_of_the_reference, ()) {
  const FlatHeating h{number(0.05, 1.0), number(0.5, 6.0), number(2e-7, 3e-6), number(1e-5, 3e-4),
                      number(280.0, 420.0)};
  const reference::FlatHeat expected{h.friction, h.rock_conductivity, h.rock_diffusivity,
                                     h.cutter_resistance, h.fluid_temperature};
  const double force = number(1.0, 5e3), speed = number(0.01, 3.0), area = number(1e-7, 5e-5),
               length = number(1e-5, 1e-2);
  const double t = reference::flat_temperature(expected, force, speed, area, length);
  RC_ASSERT(std::abs(flat_temperature(h, {force, speed, area, length}) - t) <= rounding * t);
}

/// The same worked number as for the reference, 394.15 degrees Celsius: this project's own.
TEST(BitWearLaw, the_worked_flat_is_at_394_degrees) {
  const FlatHeating worked{0.6, 2.0, 1e-6, 0.5e-4, 20.0 + ice};
  EXPECT_NEAR(flat_temperature(worked, {800.0, 0.5, 12.9e-6, 4e-3}) - ice, 394.15, 0.005);
}

TEST(BitWearLaw, a_flat_that_nothing_heats_is_as_warm_as_the_fluid) {
  const FlatHeating worked{0.6, 2.0, 1e-6, 0.5e-4, 310.0};
  EXPECT_EQ(flat_temperature(worked, {0.0, 0.5, 1e-6, 1e-3}), 310.0);
  EXPECT_EQ(flat_temperature(worked, {800.0, 0.0, 1e-6, 1e-3}), 310.0);
  EXPECT_EQ(flat_temperature(worked, {800.0, 0.5, 0.0, 1e-3}), 310.0);
  EXPECT_EQ(flat_temperature(worked, {800.0, 0.5, 1e-6, 0.0}), 310.0);
}

TEST(BitWearLaw, a_table_is_linear_between_its_rows_and_constant_beyond_them) {
  const WearLaw law = TableWear{{300.0, 600.0, 700.0}, {1e-17, 4e-17, 2e-16}};
  EXPECT_EQ(wear_coefficient(law, 250.0), 1e-17);
  EXPECT_EQ(wear_coefficient(law, 300.0), 1e-17);
  EXPECT_NEAR(wear_coefficient(law, 400.0), 2e-17, rounding * 2e-17);
  EXPECT_EQ(wear_coefficient(law, 600.0), 4e-17);
  EXPECT_NEAR(wear_coefficient(law, 650.0), 1.2e-16, rounding * 1.2e-16);
  EXPECT_EQ(wear_coefficient(law, 700.0), 2e-16);
  EXPECT_EQ(wear_coefficient(law, 900.0), 2e-16);
}

}  // namespace tdbd::bit::worn_bit_test
