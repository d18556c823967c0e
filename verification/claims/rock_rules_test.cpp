#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "core/observed_order.hpp"
#include "core/random.hpp"
#include "core/tolerance.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"
#include "reference/rock/facet_walk.hpp"
#include "rock/cut/swept_mesh.hpp"
#include "rock/cut/swept_part.hpp"
#include "verification/battery/shapes.hpp"

/// Claims of chapter 4 on its rules: update directions, the search for the exit, resolution.
namespace tdbd::claims::rock_rules_test {

/// Operations that maintenance needs under a rule, divided by the moves of vertices: with the
/// operations of the thesis, and with those of TDBD as well.
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

/// The same solid twice: by the climb over its planes, which is the default, and by a tree of boxes over its facets.
TEST(RockRules, the_search_over_planes_finds_what_the_search_over_facets_finds) {
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
               "5000 paths by a cutter of 16 mm: exit by the default search over planes against "
               "that by a tree over facets",
               worst, "m", 1e-12);
}

/// What walks over the facets of a part did (reference/rock/facet_walk.hpp).
struct Walks {
  long queries = 0, different = 0, swept = 0, answered = 0;  ///< answered: of the swept
  reference::WalkMemory memory;
  double facets = 0.0;  ///< of the part
};

/// The exits of all paths by a walk, each from the facet of the last exit, and by the tree of boxes.
Walks walk_all(const mesh::TriangleMesh& part, const std::vector<rock::RelativePath>& paths,
               double depth) {
  const mesh::TriangleTree tree(part);
  const reference::FacetNeighbours across = reference::neighbours_of(tree);
  reference::WalkScratch walking;
  rock::MeshScratch searching;
  Walks w;
  w.facets = static_cast<double>(tree.facets().size());
  for (const rock::RelativePath& path : paths) {
    const long before = walking.walk.answered;
    const auto by_walk = exit_distance_by_walk(tree, across, path, depth, walking);
    ++w.queries;
    w.different += by_walk != exit_distance(tree, path, depth, searching);
    if (!by_walk) continue;
    ++w.swept;
    w.answered += walking.walk.answered - before;
  }
  w.memory = walking.walk;
  return w;
}

/// Limits of a part's walks: facets that one tests over all facets, and the share of swept vertices
/// whose exit takes the tree of boxes.
struct WalkLimits {
  double tested, by_tree;
};

void record_walks(const std::string& part, const Walks& w, const WalkLimits& limits) {
  const std::string where = "walks over facets, " + part + ": ";
  EXPECT_GT(w.swept, 1000);
  record_bound("chapter4/search", where + "exits that differ from those by the tree of boxes",
               static_cast<double>(w.different), "1", 0.0);
  record_bound("chapter4/search",
               where +
                   "facets tested by a walk that finds the exit, mean, over "
                   "all facets",
               static_cast<double>(w.memory.facets_tested_by_found) /
                   static_cast<double>(w.memory.found) / w.facets,
               "1", limits.tested);
  record_bound(
      "chapter4/search", where + "share of swept vertices whose exit takes the tree of boxes",
      1.0 - static_cast<double>(w.answered) / static_cast<double>(w.swept), "1", limits.by_tree);
}

/// Neighbouring vertices around a torus, and vertices at random places in a cutter.
TEST(RockRules, walks_over_facets_find_the_exits_of_the_tree) {
  std::vector<rock::RelativePath> around, anywhere;
  for (double a = 0.0; a < 6.0; a += 1e-3) {
    const double r = 1.0 + 0.33 * std::sin(37.0 * a);
    const Vec3 x(r * std::cos(a), r * std::sin(a), 0.27 - 0.05 * std::cos(11.0 * a));
    around.push_back({x, x + Vec3(0, 1e-3, -1e-3), Vec3(0, 0, 1), Vec3(0, 0, 1)});
  }
  Random random{11};
  for (int k = 0; k < 5000; ++k) anywhere.push_back(any_path(random));
  record_walks("6000 neighbouring vertices at a torus",
               walk_all(battery::torus(1.0, 0.3, 64, 32), around, 1e-9), {0.001, 0.03});
  record_walks("5000 random vertices at a cutter of 16 mm",
               walk_all(battery::cylinder(8e-3, 8e-3, 64), anywhere, 16e-3 * tolerance::swept),
               {0.2, 0.25});
}

/// Unfavourable: all that cuts of the example bits is convex.
TEST(RockRules, parts_that_cut_of_the_example_bits_are_convex) {
  long walked = 0, parts = 0;
  for (const char* name : {"bit-a", "bit-b", "bit-c", "bit-r"})
    for (const rock::CuttingGroup& g : rock::prepare_cutting_bit(example(name)).groups)
      for (const rock::CuttingPart& p : g.parts) {
        ++parts;
        walked += p.tree_P.has_value();
      }
  EXPECT_GT(parts, 100);
  EXPECT_EQ(walked, 0);
  battery::record({"chapter4/search",
                   "bits A, B, C and R: share of cutting parts that are not convex, so that a walk "
                   "could find their exits",
                   static_cast<double>(walked) / static_cast<double>(parts), "1",
                   "above 0, did bits need walks: convex parts are searched by their planes, and "
                   "each look tests all planes near the vertex",
                   battery::Verdict::holds_with_limits});
}

/// A tool that is pressed straight down into flat rock: its mesh with the lowest point at z = 0, the
/// depth of its dent below a place, and the volume of the dent.
struct Press {
  const char* name;
  mesh::TriangleMesh mesh;
  std::function<double(const Vec3&)> dent;
  double volume;       ///< m3
  double order, room;  ///< of the volume between dent and mesh over the edge length
  double error;        ///< limit of that volume at edges of 0.25 mm over the dent's
};

constexpr double pi = std::numbers::pi;
constexpr double dent_depth = 4e-3;  // m

Press ball() {
  constexpr double radius = 10e-3;
  return {"ball of 20 mm",
          battery::placed({Mat3::Identity(), Vec3(0, 0, -radius)}, battery::sphere(radius, 6)),
          [](const Vec3& x) {
            const double under = radius * radius - x.head<2>().squaredNorm();
            return std::max(0.0, std::sqrt(std::max(0.0, under)) + dent_depth - radius);
          },
          pi * dent_depth * dent_depth * (radius - dent_depth / 3.0),
          2.0,
          0.3,
          0.0045};
}

/// Half the angle of its tip is 45 degrees.
Press sharp_cone() {
  constexpr int sides = 512;
  constexpr double height = 8e-3;
  mesh::TriangleMesh m;
  m.positions = {Vec3::Zero(), Vec3(0, 0, -height)};
  for (int k = 0; k < sides; ++k) {
    const double a = 2.0 * pi * k / sides;
    m.positions.emplace_back(height * std::cos(a), height * std::sin(a), -height);
    const int p = 2 + k, q = 2 + (k + 1) % sides;
    m.triangles.push_back({0, p, q});
    m.triangles.push_back({1, q, p});
  }
  return {"cone with a sharp tip",
          m,
          [](const Vec3& x) { return std::max(0.0, dent_depth - x.head<2>().norm()); },
          pi * dent_depth * dent_depth * dent_depth / 3.0,
          2.0,
          0.3,
          0.01};
}

Press ring() {
  constexpr double major = 8e-3, minor = 5e-3;
  const double half = std::acos(1.0 - dent_depth / minor);
  return {"ring with a core inside",
          battery::placed({Mat3::Identity(), Vec3(0, 0, -minor)},
                          battery::torus(major, minor, 256, 128)),
          [](const Vec3& x) {
            const double s = x.head<2>().norm() - major;
            return std::max(0.0,
                            std::sqrt(std::max(0.0, minor * minor - s * s)) + dent_depth - minor);
          },
          2.0 * pi * major * minor * minor * (half - std::sin(half) * std::cos(half)),
          2.0,
          0.5,
          0.0045};
}

/// Upright walls, sharp edges and a re-entrant corner. Turned, so that no edge is along the rock's.
Press angle_block() {
  constexpr double size = 16e-3, arm = 6e-3, turn = 0.3;
  const auto outline = battery::l_outline(size, arm);
  const Mat3 R = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
  const auto inside = [outline](const Eigen::Vector2d& p) {
    bool odd = false;
    for (std::size_t i = 0, k = outline.size() - 1; i < outline.size(); k = i++) {
      const Eigen::Vector2d &a = outline[i], &b = outline[k];
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
        odd = !odd;
    }
    return odd;
  };
  return {"L with upright walls",
          battery::placed({R, Vec3::Zero()}, battery::prism(outline, -8e-3, 0.0)),
          [inside, R](const Vec3& x) {
            const Vec3 own = R.transpose() * x;
            return inside(own.head<2>()) ? dent_depth : 0.0;
          },
          dent_depth * (size * size - (size - arm) * (size - arm)),
          1.0,
          0.006,
          0.1};
}

/// Integral over a triangle's shadow of its height's distance from the dent: the centroids of
/// 64 equal parts.
double volume_between(const Press& p, const Vec3& a, const Vec3& b, const Vec3& c, int levels) {
  if (levels == 0) {
    const Vec3 middle = (a + b + c) / 3.0;
    return std::abs(middle.z() - p.dent(middle)) * std::abs(mesh::area_vector(a, b, c).z());
  }
  const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  return volume_between(p, a, ab, ca, levels - 1) + volume_between(p, ab, b, bc, levels - 1) +
         volume_between(p, ca, bc, c, levels - 1) + volume_between(p, ab, bc, ca, levels - 1);
}

/// Volume between the true dent and the one that the tool leaves in flat rock of this edge length,
/// over the volume of the dent.
double dent_error(const Press& p, double edge) {
  constexpr double half = 16e-3;
  bit::Bit tool;
  tool.parts.resize(1);
  tool.parts[0].name = "tool";
  tool.parts[0].kind = bit::PartKind::tooth;
  tool.parts[0].mesh_P = p.mesh;
  tool.parts[0].group = 0;
  const int n = static_cast<int>(std::lround(2.0 * half / edge));
  rock::Rock flat = rock::make_rock(mesh::make_surface(battery::flat_rock(half, 0.0, n)),
                                    2.0 * edge, {Vec3::Constant(-half), Vec3::Constant(half)});
  rock::CutWorkspace work;
  rock::CutReport report;
  rock::cut_rock(flat, rock::prepare_cutting_bit(tool), {Mat3::Identity(), Vec3(0, 0, -1e-3)},
                 {Mat3::Identity(), Vec3(0, 0, dent_depth)}, work, report);
  double between = 0.0;
  for (const auto& [a, b, c] : flat.surface.triangles)
    between += volume_between(p, flat.surface.position(a), flat.surface.position(b),
                              flat.surface.position(c), 3);
  return between / p.volume;
}

void approximate(const Press& p) {
  std::vector<double> edges, errors;
  edges.reserve(4);
  errors.reserve(4);
  for (const double edge : {2e-3, 1e-3, 0.5e-3, 0.25e-3}) {
    edges.push_back(edge);
    errors.push_back(dent_error(p, edge));
    fmt::print("{}, edge {:.2f} mm: {:.3e}\n", p.name, 1e3 * edge, errors.back());
    EXPECT_TRUE(errors.size() == 1 || errors.back() < errors[errors.size() - 2]) << p.name;
  }
  const std::string what = fmt::format("dent of a {}, 4 mm deep: ", p.name);
  record_near("chapter4/any-shape",
              what + "order of the volume between it and the mesh, edges of 2 to 0.25 mm",
              least_squares_order(edges, errors), p.order, p.room);
  record_bound("chapter4/any-shape", what + "the same volume at edges of 0.25 mm, over the dent's",
               errors.back(), "1", p.error);
}

TEST(RockRules, a_finer_mesh_approximates_a_ball_a_cone_and_a_ring_better) {
  for (const Press& p : {ball(), sharp_cone(), ring()}) approximate(p);
}

TEST(RockRules, a_finer_mesh_approximates_upright_walls_and_a_re_entrant_corner_better) {
  approximate(angle_block());
}

}  // namespace tdbd::claims::rock_rules_test
