#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "claims/example_bits.hpp"
#include "core/observed_order.hpp"
#include "core/random.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/hausdorff.hpp"
#include "reference/rock/close_surface.hpp"
#include "reference/rock/swept_boolean.hpp"
#include "rock/cut/cut_rock.hpp"
#include "verification/battery/shapes.hpp"

/// Moving vertices against the exact boolean (CGAL, exact kernel) on flat rock, which both
/// represent exactly: volume and Hausdorff distance over the edge length and over the time step.
namespace tdbd::claims::boolean_orders_test {

constexpr double half = 0.8, window = 0.7;  ///< m, of the rock; of what is compared

/// A part and the poses that it goes through, m.
struct Sweep {
  std::string name;
  mesh::TriangleMesh part_P;
  std::vector<Pose> X_WP;
};

/// Upright disc that faces along y, its middle 0.25 above the rock, so its groove is 0.15 deep.
Pose upright_disc() {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = Vec3::UnitZ();
  X.R.col(2) = -Vec3::UnitY();
  X.p = Vec3(0, 0, -0.25);
  return X;
}

Pose turned_about_z(double angle, const Pose& X, const Vec3& axis) {
  const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  return {R * X.R, axis + R * (X.p - axis)};
}

Pose moved(Pose X, const Vec3& by) {
  X.p += by;
  return X;
}

Sweep straight_groove() {
  return {"disc, straight groove",
          battery::cylinder(0.4, 0.1, 24),
          {moved(upright_disc(), Vec3(0, -0.16, 0)), moved(upright_disc(), Vec3(0, 0.16, 0))}};
}

/// The disc goes obliquely over the rows of the mesh, and down.
Sweep oblique_groove() {
  const Pose X = turned_about_z(0.4, upright_disc(), Vec3::Zero());
  const Vec3 way(-0.12, 0.28, 0.08);
  return {"disc, oblique and down",
          battery::cylinder(0.4, 0.1, 24),
          {moved(X, -0.5 * way), moved(X, 0.5 * way)}};
}

/// A box on its edge: a groove whose flanks meet in a sharp line.
Sweep wedge_groove() {
  Pose X{Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()).toRotationMatrix(),
         Vec3(0, 0, -0.15)};
  X = turned_about_z(0.3, X, Vec3::Zero());
  const Vec3 way = X.R * Vec3(0, 0.3, 0);
  return {"wedge, along its edge",
          battery::box({-0.25, -0.1, -0.25}, {0.25, 0.1, 0.25}),
          {moved(X, -0.5 * way), moved(X, 0.5 * way)}};
}

/// The disc turns about an upright axis, in equal steps.
Sweep rotating_disc(double turn, int steps, const Vec3& axis) {
  Sweep s{"disc, turning about an axis", battery::cylinder(0.4, 0.1, 24), {}};
  for (int i = 0; i <= steps; ++i)
    s.X_WP.push_back(
        turned_about_z(turn * (static_cast<double>(i) / steps - 0.5), upright_disc(), axis));
  return s;
}

bit::Bit bit_of(const Sweep& s) {
  bit::Bit b;
  b.parts.resize(1);
  b.parts[0].name = "part";
  b.parts[0].mesh_P = s.part_P;
  b.parts[0].X_BP.R = s.X_WP.front().R;
  return b;
}

/// The bit's frame is upright, so that rock moves straight down.
Pose bit_pose(const Sweep& s, std::size_t i) {
  return {s.X_WP[i].R * s.X_WP.front().R.transpose(), s.X_WP[i].p};
}

struct Cut {
  double removed = 0.0;  ///< m3
  mesh::TriangleMesh rock_W;
};

/// By our program, on n x n cells that are shifted sideways.
Cut ours(const Sweep& s, int n, const Vec3& shift) {
  mesh::TriangleMesh flat = battery::flat_rock(half, 0.0, n);
  for (Vec3& x : flat.positions) x += shift;
  rock::Rock rock =
      rock::make_rock(mesh::make_surface(flat), 4.0 * half / n, mesh::bounding_box(flat));
  const rock::CuttingBit bit = rock::prepare_cutting_bit(bit_of(s));
  rock::CutWorkspace work;
  rock::CutReport report;
  Cut cut;
  for (std::size_t i = 0; i + 1 < s.X_WP.size(); ++i) {
    cut_rock(rock, bit, bit_pose(s, i), bit_pose(s, i + 1), work, report);
    cut.removed += report.removed;
  }
  cut.rock_W = mesh::compact(rock.surface);
  return cut;
}

/// The exact surface that is left, without the block's sides and bottom.
Cut exact(const Sweep& s) {
  const auto block = reference::close_surface(battery::flat_rock(half, 0.0, 2), 1.0);
  reference::SweptBoolean b = reference::swept_boolean(block, s.part_P, s.X_WP);
  const auto is_block = [&](int v) {
    return b.left_W.positions[static_cast<std::size_t>(v)].z() > 0.9;
  };
  std::erase_if(b.left_W.triangles, [&](const mesh::Triangle& t) {
    return is_block(t[0]) || is_block(t[1]) || is_block(t[2]);
  });
  return {b.removed, b.left_W};
}

struct Level {
  double step, volume,
      distance;  ///< edge length (m); rms of the volume's share; largest distance (m)
};

Level level(const Sweep& s, const Cut& truth, int n) {
  constexpr int places = 3;
  Random random{7};
  Level l{2.0 * half / n, 0.0, 0.0};
  for (int k = 0; k < places; ++k) {
    const Vec3 shift(random.uniform(0, l.step), random.uniform(0, l.step), 0.0);
    const Cut cut = ours(s, n, shift);
    const double share = cut.removed / truth.removed - 1.0;
    l.volume += share * share / places;
    l.distance = std::max(l.distance,
                          reference::hausdorff(cut.rock_W, truth.rock_W, {0.7 * l.step, window}));
  }
  l.volume = std::sqrt(l.volume);
  return l;
}

struct Orders {
  double volume, distance;
};

Orders orders_of(const std::vector<Level>& levels) {
  std::vector<double> steps, volumes, distances;
  for (const Level& l : levels) {
    steps.push_back(l.step);
    volumes.push_back(l.volume);
    distances.push_back(l.distance);
  }
  return {least_squares_order(steps, volumes), least_squares_order(steps, distances)};
}

void add_rows(const std::string& name, const std::vector<Level>& levels,
              nlohmann::ordered_json& rows) {
  for (const Level& l : levels) {
    fmt::print("{:30} {:.5f}: volume {:.2e}, distance {:.2e} m\n", name, l.step, l.volume,
               l.distance);
    rows.push_back(
        {{"sweep", name}, {"step", l.step}, {"volume", l.volume}, {"distance_m", l.distance}});
  }
  const Orders o = orders_of(levels);
  fmt::print("{:30} orders: volume {:.2f}, distance {:.2f}\n", name, o.volume, o.distance);
}

/// Upright walls stand where a vertex happens to be, so the distance is that of an edge: order 1.
/// What is missed at one wall is taken at another, so volumes converge with order 2, except for a
/// groove along the rows of the mesh, where all of a wall is missed or taken at once: order 1. The
/// exact boolean of a turn is that of its two chords.
TEST(BooleanOrders, vertex_motion_converges_to_the_exact_boolean_as_edges_shrink) {
  nlohmann::ordered_json rows;
  for (const Sweep& s : {straight_groove(), oblique_groove(), wedge_groove(),
                         rotating_disc(0.03, 2, Vec3(10, 0, 0))}) {
    const Cut truth = exact(s);
    std::vector<Level> levels;
    for (const int n : {12, 24, 48, 96, 192}) levels.push_back(level(s, truth, n));
    add_rows(s.name, levels, rows);
    const Orders o = orders_of(levels);
    EXPECT_GE(o.volume, 0.9) << s.name;
    EXPECT_GE(o.distance, 0.8) << s.name;
  }
  battery::record_table("boolean-over-edges", rows);
}

/// Largest distance between the places of the same vertex, and the volumes' difference as a share.
Level difference(const Cut& a, const Cut& b, double step) {
  Level l{step, std::abs(a.removed / b.removed - 1.0), 0.0};
  for (std::size_t v = 0; v < a.rock_W.positions.size(); ++v)
    l.distance = std::max(l.distance, (a.rock_W.positions[v] - b.rock_W.positions[v]).norm());
  return l;
}

/// On one mesh, against very short steps: the error of a vertex's straight path within a step.
/// The disc turns by half a radian about an axis 1 m away.
TEST(BooleanOrders, vertex_motion_is_of_second_order_in_the_time_step) {
  constexpr double turn = 0.5;
  constexpr int n = 96;
  const Vec3 axis(1.0, 0, 0), shift(0.3e-3, 0.7e-3, 0);
  const Cut truth = ours(rotating_disc(turn, 512, axis), n, shift);
  std::vector<Level> levels;
  for (const int steps : {1, 2, 4, 8, 16})
    levels.push_back(
        difference(ours(rotating_disc(turn, steps, axis), n, shift), truth, turn / steps));
  nlohmann::ordered_json rows;
  add_rows("disc, steps of a turn (rad)", levels, rows);
  battery::record_table("boolean-over-time-steps", rows);
  const Orders o = orders_of(levels);
  EXPECT_GE(o.volume, 1.8);
  EXPECT_GE(o.distance, 1.8);
}

}  // namespace tdbd::claims::boolean_orders_test
