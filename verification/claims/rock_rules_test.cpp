#include <algorithm>
#include <cmath>
#include <numbers>

#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "core/observed_order.hpp"
#include "core/random.hpp"
#include "core/tolerance.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/swept_part.hpp"
#include "verification/battery/shapes.hpp"

/// Claims of chapter 4 on its rules: update directions, the search for the exit, resolution.
namespace tdbd::claims::rock_rules_test {

/// Operations that maintenance needs under a rule, over the moves of vertices: the thesis's, and
/// with ours.
struct PerMove {
  double thesis, all;
};

/// 33 mm of hole by bit B at 3 mm edges.
PerMove operations_per_move(const std::string& rule) {
  const simulation::Case c = rock_case(
      "bit-b-steady", {"rock.edge_length='3 mm'", "time.revolutions=4", "time.step='5 ms'",
                       "motion.rate_of_penetration='60 m/h'", "update.directions='" + rule + "'"});
  simulation::Simulation s = simulation::start(c);
  long moves = 0;
  while (s.state.steps_done < c.time.steps) {
    simulation::step(c, s);
    moves += s.state.cut.moved;
  }
  return {static_cast<double>(thesis_operations(s)) / static_cast<double>(moves),
          static_cast<double>(operations(s)) / static_cast<double>(moves)};
}

TEST(RockRules, inside_and_outside_cutters_save_maintenance) {
  const PerMove hybrid = operations_per_move("hybrid");
  record_bound("chapter4/few-operations",
               "bit B, 33 mm of hole: operations of 4.2.1 to 4.2.3 over moves of vertices",
               hybrid.thesis, "1", few);
  for (const char* other : {"all-down", "along-profile"})
    record_bound("chapter4/update-directions",
                 fmt::format("bit B, 33 mm of hole: operations a move with inside and outside "
                             "cutters, over those with {}",
                             other),
                 hybrid.all / operations_per_move(other).all, "1", 1.0);
}

Vec3 any_unit(Random& random) {
  Vec3 v;
  do {
    v = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  } while (v.norm() > 1.0 || v.norm() < 0.1);
  return v.normalized();
}

/// A vertex on its way through a disc of 16 mm, with a direction that turns a little.
rock::RelativePath any_path(Random& random) {
  const auto place = [&random] {
    return Vec3(random.uniform(-6e-3, 6e-3), random.uniform(-6e-3, 6e-3),
                random.uniform(-3e-3, 3e-3));
  };
  const Vec3 q = place(), u = any_unit(random);
  return {q, q + 2e-3 * any_unit(random), u, (u + 0.05 * any_unit(random)).normalized()};
}

/// The same solid twice: by a walk from plane to plane, and by all facets that a strip meets.
TEST(RockRules, the_search_finds_what_testing_all_facets_finds) {
  rock::CuttingPart by_planes, by_facets;
  const mesh::TriangleMesh disc = battery::cylinder(8e-3, 8e-3, 64);
  by_planes.solid_P = mesh::convex_solid(disc).value();
  by_facets.tree_P.emplace(disc);
  by_planes.depth = by_facets.depth = 16e-3 * tolerance::swept;
  rock::SweptScratch scratch;
  Random random{11};
  double worst = 0.0;
  long swept = 0;
  for (int k = 0; k < 5000; ++k) {
    const rock::RelativePath path = any_path(random);
    const auto a = rock::exit_distance(by_planes, path, scratch),
               b = rock::exit_distance(by_facets, path, scratch);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    ++swept;
    worst = std::max(worst, std::abs(*a - *b));
  }
  EXPECT_GT(swept, 2500);
  record_bound("chapter4/search",
               "5000 vertices swept by a cutter of 16 mm: exit found from plane to plane against "
               "that of all facets",
               worst, "m", 1e-12);
}

constexpr double ball_radius = 10e-3, dent_depth = 5e-3;  // m

/// Depth of the ball's dent in the plane z = 0 below a place.
double dent(const Vec3& x) {
  const double under = ball_radius * ball_radius - x.head<2>().squaredNorm();
  return std::max(0.0, std::sqrt(std::max(0.0, under)) + dent_depth - ball_radius);
}

/// Integral over a triangle's shadow of its height's distance from the dent: the centroids of
/// 64 equal parts.
double volume_between(const Vec3& a, const Vec3& b, const Vec3& c, int levels) {
  if (levels == 0) {
    const Vec3 middle = (a + b + c) / 3.0;
    return std::abs(middle.z() - dent(middle)) * std::abs(mesh::area_vector(a, b, c).z());
  }
  const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  return volume_between(a, ab, ca, levels - 1) + volume_between(ab, b, bc, levels - 1) +
         volume_between(ca, bc, c, levels - 1) + volume_between(ab, bc, ca, levels - 1);
}

/// Volume between the true dent of a ball of 20 mm, 5 mm deep, and the one that it leaves in flat
/// rock of this edge length, over the volume of the dent.
double dent_error(double edge) {
  constexpr double half = 16e-3;
  bit::Bit ball;
  ball.parts.resize(1);
  ball.parts[0].name = "ball";
  ball.parts[0].kind = bit::PartKind::tooth;
  ball.parts[0].mesh_P = battery::sphere(ball_radius, 6);
  ball.parts[0].group = 0;
  const int n = static_cast<int>(std::lround(2.0 * half / edge));
  rock::Rock flat = rock::make_rock(mesh::make_surface(battery::flat_rock(half, 0.0, n)),
                                    2.0 * edge, {Vec3::Constant(-half), Vec3::Constant(half)});
  rock::CutWorkspace work;
  rock::CutReport report;
  rock::cut_rock(flat, rock::prepare_cutting_bit(ball),
                 {Mat3::Identity(), Vec3(0, 0, -1.1 * ball_radius)},
                 {Mat3::Identity(), Vec3(0, 0, dent_depth - ball_radius)}, work, report);
  double between = 0.0;
  for (const auto& [a, b, c] : flat.surface.triangles)
    between += volume_between(flat.surface.position(a), flat.surface.position(b),
                              flat.surface.position(c), 3);
  return between / (std::numbers::pi * dent_depth * dent_depth * (ball_radius - dent_depth / 3.0));
}

TEST(RockRules, a_finer_mesh_approximates_any_shape_better) {
  std::vector<double> edges, errors;
  edges.reserve(4);
  errors.reserve(4);
  for (const double edge : {2e-3, 1e-3, 0.5e-3, 0.25e-3}) {
    edges.push_back(edge);
    errors.push_back(dent_error(edge));
    fmt::print("edge {:.2f} mm: {:.3e}\n", 1e3 * edge, errors.back());
  }
  record_near("chapter4/any-shape",
              "dent of a ball of 20 mm, 5 mm deep: order of the volume between it and the mesh, "
              "edges of 2 to 0.25 mm",
              least_squares_order(edges, errors), 2.0, 0.3);
  record_bound("chapter4/any-shape", "the same at edges of 0.25 mm, over the volume of the dent",
               errors.back(), "1", 0.0045);
}

}  // namespace tdbd::claims::rock_rules_test
