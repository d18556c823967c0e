#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simulation/case/case.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/sound_rock.hpp"

namespace tdbd::simulation::general_motion_test {

constexpr double pi = std::numbers::pi;

/// A regular polygon's area over its circle's.
double polygon_share(int sides) { return std::sin(2.0 * pi / sides) * sides / (2.0 * pi); }

/// A disc about the bit's axis, middle at its origin, that moves rock outwards or down.
struct Disc {
  double radius = 20e-3, height = 8e-3;
  int sides = 128;
  const char* direction = "[1, 0, 0]";
};

std::string write_disc(const std::filesystem::path& folder, const Disc& d) {
  return write_one_part_bit(
      folder, battery::cylinder(1e3 * d.radius, 1e3 * d.height, d.sides),
      std::string("kind = \"tooth\"\nupdate_direction = ") + d.direction + "\n");
}

Case disc_case(const Disc& d, const std::string& rock, const std::string& motion_and_time) {
  const auto folder = test_folder();
  write_disc(folder, d);
  return read_case(write_file(folder / "case.toml", "[bit]\nfile = \"bit.toml\"\n[rock]\n" + rock +
                                                        "\n" + motion_and_time),
                   {});
}

std::string leg(double seconds, const Vec3& mm_per_s) {
  return fmt::format("[[motion.legs]]\nduration = {}\nvelocity = [{}, {}, {}]\n", seconds,
                     1e-3 * mm_per_s.x(), 1e-3 * mm_per_s.y(), 1e-3 * mm_per_s.z());
}

/// Common area of two circles of radii a and b, their centres d apart.
double lens(double a, double b, double d) {
  const double x = (d * d + a * a - b * b) / (2.0 * d), y = d - x;
  return a * a * std::acos(x / a) - x * std::sqrt(a * a - x * x) + b * b * std::acos(y / b) -
         y * std::sqrt(b * b - y * y);
}

/// Area seen from above of the faces that look down by more than 45 degrees, m2.
double roof_area(const mesh::Surface& s) {
  double area = 0.0;
  for (const mesh::Triangle& t : s.triangles) {
    if (t[0] < 0) continue;
    const Vec3 a = mesh::area_vector(s.position(t[0]), s.position(t[1]), s.position(t[2]));
    if (a.z() > std::sqrt(0.5) * a.norm()) area += a.z();
  }
  return area;
}

/// How often the vertical line through (x, y) meets the surface.
int crossings(const mesh::Surface& s, double x, double y) {
  const auto side = [&](int a, int b) {
    const Vec3 &p = s.position(a), &q = s.position(b);
    return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x()) > 0.0;
  };
  int n = 0;
  for (const mesh::Triangle& t : s.triangles) {
    if (t[0] < 0) continue;
    const bool first = side(t[0], t[1]);
    n += static_cast<int>(first == side(t[1], t[2]) && first == side(t[2], t[0]));
  }
  return n;
}

/// A disc in a hole that is wider goes sideways into its wall.
struct Undercut {
  double hole = 25e-3, way = 12e-3;
  Disc disc;

  double area() const {
    return polygon_share(disc.sides) * pi * disc.radius * disc.radius -
           lens(disc.radius, hole, way);
  }
};

constexpr const char* narrow_hole =
    "shape = \"profile\"\nprofile = [[0, 0.03], [0.025, 0.03], [0.025, -0.03]]\nedge_length = ";

Case undercut(const Undercut& u, double edge, const std::string& more = "") {
  return disc_case(
      u.disc, narrow_hole + std::to_string(edge),
      "[motion]\nkind = \"legs\"\n" + leg(0.24, {50, 0, 0}) + more + "[time]\nstep = 0.002\n");
}

/// The groove has a floor and a roof: a vertical line meets the surface there twice, where a height
/// field has one height. Its volume and the shadow of its roof are known: the disc at the end less
/// its lens with the hole. The groove's rims are as blurred as the edges are long.
TEST(Sideways, a_disc_undercuts_the_wall) {
  const Undercut u;
  for (const double edge : {2e-3, 1e-3}) {
    const Case c = undercut(u, edge);
    Simulation s = start(c);
    EXPECT_EQ(roof_area(s.state.rock.surface), 0.0);
    EXPECT_EQ(crossings(s.state.rock.surface, 0.0291, 0.0003), 0);
    run_out(c, s, 7);
    EXPECT_EQ(crossings(s.state.rock.surface, 0.0291, 0.0003), 2);
    const double volume = s.state.ledger.removed.value() / (u.area() * u.disc.height);
    const double roof = roof_area(s.state.rock.surface) / u.area();
    const auto pairs = reference::self_intersecting_pairs(mesh::compact(s.state.rock.surface));
    fmt::print("edges of {:.1f} mm: volume {:.4f}, roof {:.4f} of the exact, {} pairs\n",
               1e3 * edge, volume, roof, pairs);
    EXPECT_NEAR(volume, 1.0, 60.0 * edge);
    EXPECT_NEAR(roof, 1.0, 57.0 * edge);
    EXPECT_LE(ledger_defect(s), tolerance::ledger);
    EXPECT_TRUE(mesh::check_surface(mesh::compact(s.state.rock.surface)).empty());
    if (edge == 2e-3) {  // at 1 mm maintenance makes folds of a micrometre: src/rock/README.md
      EXPECT_EQ(pairs, 0U);
    }
  }
}

/// Under a roof, straight down is no way out of the rock ahead: what the disc meets first goes down
/// beside it, and then no vertex comes to meet it any more. The direction that a part needs is the
/// one in which it cuts.
TEST(Sideways, straight_down_leaves_the_rock_ahead_of_an_undercutting_disc) {
  Undercut u;
  u.disc.direction = "[0, 0, 1]";
  const Case c = undercut(u, 2e-3);
  Simulation s = start(c);
  run_out(c, s, 7);
  EXPECT_LE(ledger_defect(s), tolerance::ledger);
  const double volume = s.state.ledger.removed.value() / (u.area() * u.disc.height);
  const auto pairs = reference::self_intersecting_pairs(mesh::compact(s.state.rock.surface));
  fmt::print("straight down: {:.4f} of the exact volume, {} intersecting pairs\n", volume, pairs);
  EXPECT_LT(volume, 0.01);
}

/// From below, the disc takes the roof of its groove away: what is left is open upwards.
TEST(Sideways, going_up_from_an_undercut_takes_its_roof) {
  const Undercut u;
  const Case c = undercut(u, 2e-3, leg(0.3, {0, 0, -50}));
  Simulation s = start(c);
  run_out(c, s, 7);
  expect_sound(s);
  const double up = 15e-3;
  const double volume = s.state.ledger.removed.value() / (u.area() * (u.disc.height + up));
  fmt::print("sideways and up: {:.4f} of the exact volume\n", volume);
  EXPECT_NEAR(volume, 1.0, 0.032);
}

constexpr double gage = 47.5e-3;  ///< m, of cases/bits/outside.toml

Case outside_case(const std::string& rock, const std::string& motion_and_time) {
  return read_case(write_file(test_folder() / "case.toml", "[bit]\nfile = \"" TDBD_SOURCE_DIR
                                                           "/cases/bits/outside.toml\"\n[rock]\n" +
                                                               rock + "\n" + motion_and_time),
                   {});
}

const std::string fast = "rotary_speed = \"120 rpm\"\nrate_of_penetration = \"60 m/h\"\n";

/// The mouth of 120 mm leads to a hole of 70 mm: the bit, 95 mm, makes it 95 mm wide, but for the
/// ridges between the passes of its gage cutters, 8.3 mm apart.
TEST(Reaming, a_bit_opens_a_narrower_hole_to_its_gage) {
  const Case c = outside_case(
      "shape = \"profile\"\nedge_length = 0.003\nprofile = [[0, 0.07], [0.035, 0.07], "
      "[0.035, 0], [0.06, 0], [0.06, -0.03]]",
      "[motion]\n" + fast + "[time]\nstep = 0.002\nrevolutions = 8\n");
  Simulation s = start(c);
  run_out(c, s, 53);
  expect_sound(s);
  std::vector<double> widest(8, 0.0);  // of layers of 5 mm
  double narrowest = 1.0;
  for (int v = 0; v < s.state.rock.surface.vertex_slots(); ++v) {
    const Vec3& x = s.state.rock.surface.position(v);
    if (!s.state.rock.surface.is_alive(v) || x.z() < 0.005 || x.z() >= 0.045) continue;
    double& layer = widest[static_cast<std::size_t>((x.z() - 0.005) / 0.005)];
    layer = std::max(layer, x.head<2>().norm());
    narrowest = std::min(narrowest, x.head<2>().norm());
  }
  fmt::print("ridges stand {:.2f} mm inside of the gage\n", 1e3 * (gage - narrowest));
  for (const double r : widest) EXPECT_NEAR(r, gage, 1e-5);
  EXPECT_GT(narrowest, gage - 1.5e-3);
}

/// How far the turning bit, leaning by `angle` towards +x, reaches from its origin in the direction
/// of an azimuth: what is at the radius r and the height z about its axis reaches
/// r sqrt(1 - s^2) + z s, s = sin(angle) cos(azimuth).
double reach_of(const bit::Bit& bit, double angle, double azimuth) {
  const double s = std::sin(angle) * std::cos(azimuth);
  double reach = 0.0;
  for (const bit::Part& p : bit.parts) {
    if (p.cutting != bit::Cutting::cuts) continue;
    for (const Vec3& x_P : p.mesh_P.positions) {
      const Vec3 x_B = p.X_BP * x_P;
      reach = std::max(reach, x_B.head<2>().norm() * std::sqrt(1.0 - s * s) + x_B.z() * s);
    }
  }
  return reach;
}

/// Farthest wall of a hole deeper than 6 mm below the flat it starts from, in a direction, m.
double reach_of(const rock::Rock& rock, double azimuth) {
  double reach = 0.0;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if (rock.surface.is_alive(v) && rock.surface.position(v).z() > 0.006)
      reach = std::max(reach, rock.surface.position(v).head<2>().dot(
                                  Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth))));
  return reach;
}

/// The bit turns about its leaning axis and goes straight down: seen from above its hole is the
/// hull of ellipses, of half axes r and r cos(angle), which the bit's circles are.
/// Either way of turning the update directions makes this hole; the meshes differ.
void expect_elliptic_hole(const std::string& leaning, std::size_t most_pairs) {
  constexpr double angle = 0.1;
  const Case c = outside_case(
      "shape = \"flat\"\nradius = 0.065\nwall = 0.02\nedge_length = 0.003",
      "[update]\nleaning = \"" + leaning + "\"\n[motion]\nstart = [0, 0, -0.006]\n" + fast +
          "[motion.tilt]\nangle = 0.1\nramp = 0\n[time]\nstep = 0.002\nrevolutions = 10\n");
  Simulation s = start(c);
  run_out(c, s, 53);
  const mesh::TriangleMesh m = mesh::compact(s.state.rock.surface);
  EXPECT_LE(ledger_defect(s), tolerance::ledger);
  EXPECT_TRUE(mesh::check_surface(m).empty());
  const std::size_t pairs = reference::self_intersecting_pairs(m);
  EXPECT_LE(pairs, most_pairs);
  double nearest = 0.0, farthest = -1.0;
  for (int k = 0; k < 12; ++k) {
    const double azimuth = 2.0 * pi * k / 12.0;
    const double beyond = reach_of(s.state.rock, azimuth) - reach_of(c.bit, angle, azimuth);
    nearest = std::min(nearest, beyond);
    farthest = std::max(farthest, beyond);
  }
  fmt::print("{}: reaches {:+.4f} to {:+.4f} mm beyond the exact, {} pairs of {} triangles\n",
             leaning, 1e3 * nearest, 1e3 * farthest, pairs, m.triangles.size());
  EXPECT_LE(farthest, 5e-6);  // the chord of a step's turn: r (0.025 rad)^2 / 8
  EXPECT_GE(nearest, -0.1e-3);
}

TEST(Tilt, a_leaning_bit_drills_an_elliptic_hole) { expect_elliptic_hole("upright", 0); }

/// Maintenance leaves three intersecting pairs here: a fault that is known (src/rock/README.md).
TEST(Tilt, with_directions_about_its_own_axis_drills_an_elliptic_hole) {
  expect_elliptic_hole("bit", 3);
}

/// Up without turning, and down the same way.
TEST(Reaming, a_bit_put_back_removes_nothing_more) {
  const std::string drill =
      "[[motion.legs]]\nduration = 0.5\nrotary_speed = \"120 rpm\"\n"
      "velocity = [0, 0, \"60 m/h\"]\n";
  const Case c =
      outside_case("edge_length = 0.003", "[motion]\nkind = \"legs\"\n" + drill +
                                              leg(0.1, {0, 0, -100}) + leg(0.1, {0, 0, 100}) +
                                              "[time]\nstep = 0.002\n[maintenance]\nevery = 0\n");
  Simulation s = start(c);
  double drilled = 0.0, up = 0.0;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    if (s.state.steps_done <= 250) drilled += s.state.cut.removed;
    if (s.state.steps_done > 250 && s.state.steps_done <= 300) up += s.state.cut.removed;
    if (s.state.steps_done > 301) {
      EXPECT_EQ(s.state.cut.moved, 0) << s.state.steps_done;
    }
  }
  expect_sound(s);
  fmt::print("pulling back removed {:.2e} of what drilling did\n", up / drilled);
  EXPECT_LT(std::abs(up), 3.5e-4 * drilled);
}

/// A run that is cut in two at a maintenance, its rock saved and read again, continues like an
/// uninterrupted run.
void check_reload(const std::string& maintenance) {
  const std::string motion = "[maintenance]\nrest = 0\n" + maintenance + "[motion]\n" + fast +
                             "[time]\nstep = 0.002\nduration = 0.4\n";
  const Case whole = outside_case("edge_length = 0.003", motion);
  Simulation s = start(whole);
  constexpr long cut_at = 100;
  const auto file = test_folder() / "rock.ply";
  double before = 0.0;
  while (s.state.steps_done < whole.time.steps) {
    if (s.state.steps_done == cut_at) {
      mesh::write_mesh(file, mesh::compact(s.state.rock.surface));
      before = s.state.ledger.removed.value();
    }
    step(whole, s);
  }
  const std::string rock = "shape = \"file\"\nunit = 1\nedge_length = 0.003\nfile = \"";
  const Case rest = read_case(
      write_file(file.parent_path() / "rest.toml",
                 "[bit]\nfile = \"" TDBD_SOURCE_DIR "/cases/bits/outside.toml\"\n[rock]\n" + rock +
                     file.string() + "\"\n" + motion + "first_step = 100\n"),
      {});
  Simulation t = start(rest);
  EXPECT_EQ(t.state.steps_done, cut_at);
  while (t.state.steps_done < rest.time.steps) step(rest, t);
  const mesh::TriangleMesh a = mesh::compact(s.state.rock.surface),
                           b = mesh::compact(t.state.rock.surface);
  EXPECT_TRUE(a.positions == b.positions);
  EXPECT_TRUE(a.triangles == b.triangles);
  EXPECT_NEAR(t.state.ledger.removed.value(), s.state.ledger.removed.value() - before,
              1e-14 * s.state.ledger.hole_start);
}

/// If no vertex waits: a mesh file does not say when vertices moved.
TEST(Continuing, after_a_reload_is_the_run_without_interruption) { check_reload(""); }

/// At a renumbering, and between two.
TEST(Continuing, after_a_reload_renumbers_at_the_same_steps) {
  check_reload("renumber_every = 50\n");
  check_reload("renumber_every = 30\n");
}

/// Volume of the eighth revolution from a start of radius 55 mm.
double eighth_revolution(const std::string& shape) {
  const Case c = outside_case("edge_length = 0.003\nradius = 0.055\n" + shape,
                              "[motion]\n" + fast + "[time]\nstep = 0.002\nrevolutions = 8\n");
  Simulation s = start(c);
  run_out(c, s, 97);
  expect_sound(s);
  double last = 0.0;
  for (const double v : s.state.ledger.removed_by_revolution[7]) last += v;
  return last;
}

/// Once the bit has drilled through the roughness, a revolution removes what it does from a flat
/// start.
TEST(RoughStart, has_no_lasting_effect) {
  const double rough = eighth_revolution(
      "shape = \"rough\"\namplitude = 0.002\ncorrelation_length = 0.01\nseed = 7");
  const double flat = eighth_revolution("shape = \"flat\"");
  fmt::print("eighth revolution from a rough over that from a flat start: {:.5f}\n", rough / flat);
  EXPECT_NEAR(rough / flat, 1.0, 5e-4);
}

}  // namespace tdbd::simulation::general_motion_test
