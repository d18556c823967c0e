#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/types.hpp"
#include "reference/rock/spalled_groove.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/sound_rock.hpp"

/// One cutter that moves straight through flat rock, compared with a slow twin that shares no code
/// with it (reference/rock/spalled_groove), and with a closed form.
namespace tdbd::simulation::groove_test {
namespace {

constexpr double diameter = 13e-3, back_rake = 15.0 * degree;

struct Groove {
  double edge = 1e-3;                  ///< m
  double step = 2e-3;                  ///< s
  double depth = 3e-3;                 ///< m
  double wear = 0.0;                   ///< m, height of a wear flat
  double spacing = 0.0;                ///< m to a second groove; 0: there is none
  reference::GrooveBreakout breakout;  ///< angle 0: none
};

std::string leg(double seconds, const Vec3& way) {
  return fmt::format("[[motion.legs]]\nduration = {}\nvelocity = [{}, {}, {}]\n", seconds,
                     way.x() / seconds, way.y() / seconds, way.z() / seconds);
}

/// Down into the rock behind its middle, 36 mm straight through it, and the same beside it.
std::string legs(const Groove& g) {
  constexpr double up = 5e-3;
  std::string text =
      leg(0.1, {0, -20e-3, -up}) + leg(0.1, {0, 2e-3, g.depth + up}) + leg(0.72, {0, 36e-3, 0});
  if (g.spacing > 0.0)
    text += leg(0.1, {0, 0, -g.depth - up}) + leg(0.2, {g.spacing, -38e-3, 0}) +
            leg(0.1, {0, 2e-3, g.depth + up}) + leg(0.72, {0, 36e-3, 0});
  return text;
}

std::string spalling_table(const Groove& g) {
  if (!(g.breakout.angle > 0.0)) return "";
  return fmt::format("[spalling]\nangle = {}\ndepth_share = {}\nahead_share = {}\n",
                     g.breakout.angle, g.breakout.depth_share, g.breakout.ahead_share);
}

Case case_of(const Groove& g) {
  const auto folder = bit::test_folder();
  write_file(folder / "one.csv",
             fmt::format("bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,"
                         "profile_angle_deg,back_rake_deg,side_rake_deg,wear_mm\n"
                         "one,1,1,nose,13,5,0,0,0,15,0,{}\n",
                         1e3 * g.wear));
  write_file(folder / "one.toml",
             "name = \"one\"\ntable = \"one.csv\"\ngage_diameter = \"30 mm\"\n[cutters]\n"
             "chamfer = \"0 mm\"\nlength = \"8 mm\"\n");
  return read_case(
      write_file(
          folder / "case.toml",
          fmt::format("[bit]\nfile = \"one.toml\"\n[rock]\nshape = \"flat\"\n"
                      "radius = 0.036\nedge_length = {}\nwall = 0.01\n"
                      "[motion]\nkind = \"legs\"\n{}[time]\nstep = {}\n"
                      "duration = {}\n[measure]\nsection_at_face = \"as_ahead\"\n{}",
                      g.edge, legs(g), g.step, g.spacing > 0.0 ? 2.04 : 0.92, spalling_table(g))),
      {});
}

/// Cross-sections in m2: volumes over the way, and the section of the face.
struct Measured {
  double cut = 0.0, broken_out = 0.0, section = 0.0;
};

/// Slopes of volumes over the way, by least squares.
struct Slope {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  void add(double at, double value) {
    n += 1.0;
    x += at;
    y += value;
    xx += at * at;
    xy += at * value;
  }
  double value() const { return (n * xy - x * y) / (n * xx - x * x); }
};

/// In the middle of the last groove.
Measured measured(const Groove& g, Simulation* kept = nullptr) {
  const Case c = case_of(g);
  Simulation s = start(c);
  Slope removed, broken;
  double section = 0.0;
  const double last_leg = (g.spacing > 0.0 ? 1.32 : 0.2) + 1e-9;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    const double y = s.state.place.X_WB.p.y();
    if (time_at(c.time, s.state.steps_done) < last_leg || y < -8e-3 || y > 10e-3) continue;
    removed.add(y, s.state.ledger.removed.value());
    broken.add(y, s.state.spalling ? s.state.spalling->broken_out[0].value() : 0.0);
    section += s.work.measures.sections[0].area;
  }
  if (kept != nullptr) *kept = s;
  return {removed.value() - broken.value(), broken.value(),
          section / removed.n * std::cos(back_rake)};
}

/// The face's edge across the path, from the mesh of the bit.
reference::GrooveProfile profile_of(const Groove& g) {
  const Case c = case_of(g);
  const rock::FaceOutline face = rock::face_outline(c.bit.cutters[0], 0, c.bit.parts);
  const rock::ConvexPolygon left = rock::lower_edge(face.rim_F, rock::FaceSide::left),
                            right = rock::lower_edge(face.rim_F, rock::FaceSide::right);
  reference::GrooveProfile profile;
  const auto add = [&](const rock::Vec2& x_F) {
    profile.emplace_back(x_F.x(), (x_F.y() - left.front().y()) * std::cos(back_rake));
  };
  for (std::size_t i = left.size(); i-- > 0;) add(left[i]);
  for (const rock::Vec2& x_F : right) add(x_F);
  return profile;
}

/// The last groove of the twin.
reference::GrooveAreas expected(const Groove& g) {
  reference::SpalledRock rock(36e-3, 28800);
  const reference::GrooveProfile profile = profile_of(g);
  const reference::GrooveAreas first = rock.pass(profile, 0.0, g.depth, g.breakout);
  return g.spacing > 0.0 ? rock.pass(profile, g.spacing, g.depth, g.breakout) : first;
}

/// Relative to all that leaves the groove.
struct Errors {
  double all;         ///< of what leaves
  double broken_out;  ///< of what of it breaks out: vertices at the border belong to one of both
  double section;     ///< of the face
};

Errors errors(const Groove& g) {
  const Measured found = measured(g);
  const reference::GrooveAreas twin = expected(g);
  const double broken_out = twin.ahead + twin.beside, all = twin.cut + broken_out;
  const Errors e{(found.cut + found.broken_out) / all - 1.0, (found.broken_out - broken_out) / all,
                 (found.section - twin.cut) / all};
  fmt::print(
      "edge {:.2f} mm, step {:.1f} ms: all {:.3f} ({:.3f}), broken out {:.3f} ({:.3f}), "
      "section {:.3f} ({:.3f}) mm2; errors {:.1e} {:.1e} {:.1e}\n",
      1e3 * g.edge, 1e3 * g.step, 1e6 * (found.cut + found.broken_out), 1e6 * all,
      1e6 * found.broken_out, 1e6 * broken_out, 1e6 * found.section, 1e6 * twin.cut, e.all,
      e.broken_out, e.section);
  return e;
}

void expect_errors(const Groove& g, const Errors& most) {
  const Errors e = errors(g);
  EXPECT_LE(std::abs(e.all), most.all);
  EXPECT_LE(std::abs(e.broken_out), most.broken_out);
  EXPECT_LE(std::abs(e.section), most.section);
}

/// The section of a face in flat rock does not depend on the edges: it is that of the outline.
constexpr double exact_section = 8e-8;

TEST(Groove, breaks_out_beside_like_the_twin) {
  for (const double share : {1.0, 0.5})
    for (const double edge : {2e-3, 1e-3})
      expect_errors({.edge = edge, .breakout = {70.0 * degree, share, 0.0}},
                    {edge < 1.5e-3 ? 3e-3 : 6e-3, 1.5e-2, exact_section});
}

/// What has chipped off ahead is gone when the face comes: its section is what is left.
TEST(Groove, chips_off_ahead_like_the_twin) {
  for (const double edge : {2e-3, 1e-3})
    expect_errors({.edge = edge, .breakout = {70.0 * degree, 0.0, 0.5}}, {4e-3, 5e-3, 4e-3});
  expect_errors({.breakout = {70.0 * degree, 1.0, 0.5}}, {2e-3, 1.5e-2, 4e-4});
}

TEST(Groove, beside_another_one_finds_less_rock_like_the_twin) {
  for (const double spacing : {5e-3, 9e-3, 12e-3}) {
    expect_errors({.spacing = spacing, .breakout = {70.0 * degree, 1.0, 0.0}},
                  {2.5e-3, 2e-2, 4e-3});
    expect_errors({.spacing = spacing, .breakout = {80.0 * degree, 1.0, 0.0}},
                  {1.5e-2, 2e-2, 9e-4});
  }
  const Groove near{.spacing = 9e-3, .breakout = {70.0 * degree, 1.0, 0.0}};
  Groove plain = near;
  plain.breakout = {};
  EXPECT_LT(expected(near).cut, 0.9 * expected(plain).cut);
}

TEST(Groove, does_not_depend_on_the_time_step) {
  for (const double step : {4e-3, 1e-3})
    expect_errors({.step = step, .breakout = {70.0 * degree, 1.0, 0.0}},
                  {3e-3, 3e-2, exact_section});
}

/// A face with a flat bottom of width w: cracks start at its corners, and
///   area = w d + d^2 tan(angle)
TEST(Groove, of_a_flat_bottom_has_the_closed_form) {
  const Groove g{.depth = 2e-3, .wear = 1e-3, .breakout = {60.0 * degree, 1.0, 0.0}};
  double width = 0.0;
  for (const Eigen::Vector2d& x : profile_of(g))
    if (x.y() < 1e-9) width = std::max(width, 2.0 * x.x());
  const double flat = g.wear / std::cos(back_rake);  // in the plane of the face
  EXPECT_NEAR(width / (2.0 * std::sqrt(flat * (diameter - flat))), 1.0, 6e-3);  // rim in 64 sides
  const double exact = width * g.depth + g.depth * g.depth * std::tan(g.breakout.angle);
  const reference::GrooveAreas twin = expected(g);
  EXPECT_NEAR((twin.cut + twin.beside) / exact, 1.0, 2e-5);
  const Measured found = measured(g);
  fmt::print("width {:.3f} mm, area {:.4f} of {:.4f} mm2, twin {:.4f}\n", 1e3 * width,
             1e6 * (found.cut + found.broken_out), 1e6 * exact, 1e6 * (twin.cut + twin.beside));
  EXPECT_NEAR((found.cut + found.broken_out) / exact, 1.0, 3e-3);
}

TEST(Groove, leaves_sound_rock) {
  Simulation s;
  measured({.breakout = {70.0 * degree, 1.0, 0.5}}, &s);
  expect_sound(s);
}

}  // namespace
}  // namespace tdbd::simulation::groove_test
