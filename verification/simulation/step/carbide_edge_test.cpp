#include <gtest/gtest.h>

#include <cmath>

#include "simulation/step/simulation.hpp"

/// The shipped bit whose carbide edges are parts of the kind cse: A7 and A8, forces (6), act on them.
namespace tdbd::simulation::carbide_edge_test {
namespace {

constexpr double A7 = 0.5, A8 = 0.3;  // of the case
constexpr double strength = 65e6;     // Pa, of its rock

Case carbide_edge_case(std::vector<std::string> overrides) {
  return read_case(TDBD_SOURCE_DIR "/cases/carbide-edge-bit.toml", overrides);
}

/// Loads of the parts at the end of a run.
std::vector<PartLoad> loads_at_end(const std::vector<std::string>& overrides) {
  const Case c = carbide_edge_case(overrides);
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps) step(c, s);
  return s.work.loads.parts;
}

const std::vector<std::string> short_run{"time.revolutions=0.3"};

std::vector<std::string> with(std::vector<std::string> overrides, const std::string& more) {
  overrides.push_back(more);
  return overrides;
}

bool is_edge(const Case& c, std::size_t part) {
  return c.bit.parts[part].kind == bit::PartKind::cse;
}

TEST(CarbideEdge, is_a_part_of_each_cutter_that_a_rule_marks_as_cse) {
  const Case c = carbide_edge_case({});
  int edges = 0;
  for (std::size_t p = 0; p < c.bit.parts.size(); ++p)
    if (is_edge(c, p)) {
      EXPECT_EQ(c.bit.parts[p].cutter, edges);
      ++edges;
    }
  EXPECT_EQ(edges, 6);
  for (const CaseWarning& w : c.warnings)
    EXPECT_EQ(w.text.find("acts on no part"), std::string::npos) << w.text;
}

/// The motion is given: the rock does not know the law. Powers of two scale a force exactly.
TEST(CarbideEdge, force_is_exactly_proportional_to_its_stress_and_its_friction_to_its_ratio) {
  const Case c = carbide_edge_case({});
  const std::vector<PartLoad> usual = loads_at_end(short_run),
                              stiff = loads_at_end(with(short_run, "forces.A7=1.0")),
                              rough = loads_at_end(with(short_run, "forces.A8=0.6"));
  int loaded = 0;
  for (std::size_t p = 0; p < usual.size(); ++p) {
    const double factor = is_edge(c, p) ? 2.0 : 1.0;
    EXPECT_EQ(stiff[p].normal, factor * usual[p].normal) << c.bit.parts[p].name;
    EXPECT_EQ(stiff[p].tangential, factor * usual[p].tangential) << c.bit.parts[p].name;
    EXPECT_EQ(rough[p].normal, usual[p].normal) << c.bit.parts[p].name;
    EXPECT_EQ(rough[p].tangential, factor * usual[p].tangential) << c.bit.parts[p].name;
    if (is_edge(c, p) && usual[p].normal > 0.0) ++loaded;
  }
  EXPECT_EQ(loaded,
            4);  // behind the tips of the inner two the flat swings outwards over deeper rock
}

TEST(CarbideEdge, carries_nothing_without_a_contact_stress) {
  const Case c = carbide_edge_case({});
  const std::vector<PartLoad> none = loads_at_end(with(short_run, "forces.A7=0"));
  for (std::size_t p = 0; p < none.size(); ++p)
    if (is_edge(c, p)) {
      EXPECT_EQ(none[p].force_W.norm(), 0.0) << c.bit.parts[p].name;
    }
}

/// Area of the mesh's triangles in the plane of the wear flat, m2.
double flat_area(const Case& c, std::size_t part) {
  const mesh::TriangleMesh mesh_B = bit::mesh_B(c.bit.parts[part]);
  const bit::Cutter& cutter = c.bit.cutters[static_cast<std::size_t>(c.bit.parts[part].cutter)];
  const Vec3 n(std::sin(cutter.profile_angle) * std::cos(cutter.azimuth),
               std::sin(cutter.profile_angle) * std::sin(cutter.azimuth),
               std::cos(cutter.profile_angle));
  double area = 0.0;
  for (std::size_t i = 0; i < mesh_B.triangles.size(); ++i) {
    const auto [a, b, c_B] = mesh::corners(mesh_B, i);
    const Vec3 twice = (b - a).cross(c_B - a);
    if (twice.dot(n) > (1.0 - 1e-6) * twice.norm()) area += twice.norm() / 2.0;
  }
  return area;
}

/// How far the mean forces of the four loaded edges, over the last fifth of a turn, are from A7 Scc times their flats.
struct EdgeError {
  double normal = 0.0, friction = 0.0;  // shares; the largest
};

EdgeError edge_error(const std::string& edge_length) {
  const Case c =
      carbide_edge_case({"rock.edge_length='" + edge_length + "'", "time.revolutions=1.2"});
  Simulation s = start(c);
  std::vector<double> normal(c.bit.parts.size()), tangential(c.bit.parts.size());
  const long counted = c.time.steps / 6;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    if (s.state.steps_done <= c.time.steps - counted) continue;
    for (std::size_t p = 0; p < normal.size(); ++p) {
      normal[p] += s.work.loads.parts[p].normal / static_cast<double>(counted);
      tangential[p] += s.work.loads.parts[p].tangential / static_cast<double>(counted);
    }
  }
  EdgeError e;
  for (std::size_t p = 0; p < normal.size(); ++p) {
    if (!is_edge(c, p) || c.bit.parts[p].cutter < 2) continue;
    e.normal = std::max(e.normal, std::abs(normal[p] / (A7 * strength * flat_area(c, p)) - 1.0));
    e.friction = std::max(e.friction, std::abs(tangential[p] / (A8 * normal[p]) - 1.0));
  }
  return e;
}

/// Seen on edges of 1 and 0.5 mm: 6.1e-2, 1.5e-2; friction 5e-6, the share of slip_speed.
TEST(CarbideEdge, carries_its_share_of_the_strength_on_its_wear_flat) {
  const EdgeError coarse = edge_error("1 mm"), fine = edge_error("0.5 mm");
  EXPECT_LT(coarse.normal, 0.1);
  EXPECT_LT(fine.normal, 0.025);
  EXPECT_LT(fine.normal, 0.4 * coarse.normal);
  EXPECT_LT(fine.friction, 1e-5);
}

}  // namespace
}  // namespace tdbd::simulation::carbide_edge_test
