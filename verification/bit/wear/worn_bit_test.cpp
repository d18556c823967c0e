#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/cutter/cutter_parts.hpp"
#include "bit/generate.hpp"
#include "bit/mass_properties.hpp"
#include "bit/wear/worn_cutter.hpp"
#include "core/error.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/clip_convex.hpp"
#include "reference/literature/drag/wear/glowka_wear.hpp"

namespace tdbd::bit::worn_bit_test {
namespace {

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

/// What a cutter's meshes lost between two bits: the volumes of the pieces of the old meshes beyond
/// the flat of the new ones. Shares no function with flat_at.
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
  std::vector<double> volumes(fresh.cutters.size(), 0.0);
  volumes[3] = most;
  try {
    worn_bit(fresh, volumes);
    FAIL() << "no error";
  } catch (const RunError& e) {
    EXPECT_EQ(std::string(e.what()),
              "the flat of cutter-" + std::to_string(solid.id) + " is as large as the cutter");
  }
}

TEST(WornBit, has_the_dull_grades_of_its_worn_shares) {
  Bit bit = example_bit('b');
  for (Cutter& c : bit.cutters) c.wear = 0.0;
  EXPECT_EQ(dull_grade(bit).inner, 0);
  EXPECT_EQ(dull_grade(bit).outer, 0);
  for (Cutter& c : bit.cutters) {
    const bool inner = c.tip_radius <= bit.gage_radius * 2.0 / 3.0;
    c.wear = (inner ? 0.31 : 0.44) * c.diameter * std::cos(c.back_rake);
  }
  EXPECT_EQ(dull_grade(bit).inner, 2);  // 2.48 eighths
  EXPECT_EQ(dull_grade(bit).outer, 4);  // 3.52 eighths: a cutter of the other group changes each
  for (Cutter& c : bit.cutters) c.wear = 2.0 * c.diameter;
  EXPECT_EQ(dull_grade(bit).outer, 8);
}

}  // namespace
}  // namespace tdbd::bit::worn_bit_test
