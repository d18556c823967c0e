#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "core/error.hpp"
#include "simulation/start/rock_start.hpp"

namespace tdbd::simulation::start_surface_test {

using Words = std::vector<std::string>;

Case case_with(Words overrides) {
  overrides.insert(overrides.begin(), "rock.edge_length=12 mm");
  return read_case(TDBD_SOURCE_DIR "/cases/bit-b-steady.toml", overrides);
}

std::string bytes_of(const mesh::Surface& s) {
  std::string bytes;
  for (int v = 0; v < s.vertex_slots(); ++v)
    bytes.append(reinterpret_cast<const char*>(s.position(v).data()), sizeof(Vec3));
  for (const mesh::Triangle& t : s.triangles)
    bytes.append(reinterpret_cast<const char*>(t.data()), sizeof(t));
  return bytes;
}

Case case_of(const std::function<void(RockStart&)>& change) {
  Case c = case_with({});
  change(c.rock);
  return c;
}

void roughen(RockStart& r, double amplitude, double length, std::uint64_t seed = 1) {
  r.shape = RockShape::rough;
  r.roughness = {amplitude, length, seed};
}

void turn(RockStart& r, double radius) {
  r.shape = RockShape::profile;
  r.profile = {{0.0, 0.1}, {0.1, 0.1}, {radius, 0.0}};
}

/// Each has another surface.
std::vector<Case> others() {
  return {case_with({}),
          case_with({"bit.set.adjust.back_rake=4 deg"}),
          case_of([](RockStart& r) { r.edge_length = 9e-3; }),
          case_of([](RockStart& r) { r.wall = 20e-3; }),
          case_of([](RockStart& r) { r.shape = RockShape::flat; }),
          case_of([](RockStart& r) { r.shape = RockShape::flat, r.radius = 0.12; }),
          case_of([](RockStart& r) { roughen(r, 1e-3, 30e-3); }),
          case_of([](RockStart& r) { roughen(r, 2e-3, 30e-3); }),
          case_of([](RockStart& r) { roughen(r, 1e-3, 40e-3); }),
          case_of([](RockStart& r) { roughen(r, 1e-3, 30e-3, 2); }),
          case_of([](RockStart& r) { turn(r, 0.11); }),
          case_of([](RockStart& r) { turn(r, 0.12); })};
}

TEST(StartSurface, of_another_rock_or_bit_has_another_key) {
  std::set<std::string> surfaces, keys;
  for (const Case& c : others()) {
    EXPECT_TRUE(surfaces.insert(bytes_of(start_surface(c).surface)).second) << surfaces.size();
    EXPECT_TRUE(keys.insert(start_surface_key(c)).second) << keys.size();
  }
}

TEST(StartSurface, has_the_key_of_the_same_rock_under_another_motion) {
  const Case one = case_with({}), other = case_with({"motion.rate_of_penetration=3 m/h"});
  EXPECT_EQ(start_surface_key(one), start_surface_key(other));
  EXPECT_NE(one.hash, other.hash);
  EXPECT_EQ(bytes_of(start_surface(one).surface), bytes_of(start_surface(other).surface));
}

/// A check that a case waives is not waived for the next.
TEST(StartSurface, that_may_intersect_itself_has_another_key) {
  const Case checked = case_of([](RockStart& r) { turn(r, 0.11); });
  Case waived = checked;
  waived.rock.intersections = IntersectionCheck::none;
  EXPECT_NE(start_surface_key(checked), start_surface_key(waived));
}

/// Files have no key: what is in them is looked at each time.
TEST(StartSurface, of_a_file_has_no_key) {
  EXPECT_EQ(start_surface_key(case_of([](RockStart& r) { r.shape = RockShape::file; })), "");
}

TEST(StartSurface, of_a_short_way_is_rejected_where_the_way_needs_more_memory) {
  const Case near = case_with({});
  const StartSurface start = start_surface(near);
  EXPECT_EQ(bytes_of(start_rock(near, start).surface), bytes_of(start_rock(near).surface));
  Case far = near;
  far.motion.rate_of_penetration *= 1e9;
  EXPECT_THROW(start_rock(far, start), InputError);
}

}  // namespace tdbd::simulation::start_surface_test
