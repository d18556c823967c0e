#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "core/parallel.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/sound_rock.hpp"

/// Bits whose parts remove a share of the rock that they meet (removal.share).
namespace tdbd::simulation::removal_share_test {
namespace {

constexpr double back_rake = 15.0 * degree;

/// One cutter that moves straight through flat rock, several times in the same groove.
struct Groove {
  double share = 0.5;
  double edge = 1e-3;  ///< m
  double step = 2e-3;  ///< s
  int passes = 1;
};

constexpr double depth = 3e-3, pass_time = 1.02, up = 5e-3;

std::string leg(double seconds, const Vec3& way) {
  return fmt::format("[[motion.legs]]\nduration = {}\nvelocity = [{}, {}, {}]\n", seconds,
                     way.x() / seconds, way.y() / seconds, way.z() / seconds);
}

/// Down into the rock behind its middle, 36 mm straight through it, up and back.
std::string legs(const Groove& g) {
  std::string text = leg(0.1, {0, -20e-3, -up});
  for (int k = 0; k < g.passes; ++k)
    text += leg(0.1, {0, 2e-3, depth + up}) + leg(0.72, {0, 36e-3, 0}) +
            leg(0.1, {0, 0, -depth - up}) + leg(0.1, {0, -38e-3, 0});
  return text;
}

/// A bit of one cutter in a new folder.
std::filesystem::path write_one_cutter(double share) {
  const auto folder = bit::test_folder();
  write_file(folder / "one.csv",
             "bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,"
             "profile_angle_deg,back_rake_deg,side_rake_deg\none,1,1,nose,13,30,0,0,0,15,0\n");
  write_file(folder / "one.toml",
             fmt::format("name = \"one\"\ntable = \"one.csv\"\ngage_diameter = \"80 mm\"\n"
                         "[cutters]\nchamfer = \"0 mm\"\nlength = \"3 mm\"\n"
                         "[areas.a]\nnames = \"cutter-1/*\"\nremoval.share = {}\n",
                         share));
  return folder;
}

Case case_of(const Groove& g) {
  const auto folder = write_one_cutter(g.share);
  return read_case(write_file(folder / "case.toml",
                              fmt::format("[bit]\nfile = \"one.toml\"\n[rock]\nshape = \"flat\"\n"
                                          "radius = 0.046\nedge_length = {}\nwall = 0.01\n"
                                          "[motion]\nkind = \"legs\"\n{}[time]\nstep = {}\n"
                                          "duration = {}\n",
                                          g.edge, legs(g), g.step, 0.1 + pass_time * g.passes)),
                   {});
}

/// Slope over the way, by least squares.
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

/// m2 across the path, of each pass: what was removed and what the face met.
struct Pass {
  double removed = 0.0, met = 0.0;
};

std::vector<Pass> passes_of(const Groove& g, Simulation* kept = nullptr) {
  const Case c = case_of(g);
  Simulation s = start(c);
  std::vector<Slope> removed(static_cast<std::size_t>(g.passes));
  std::vector<double> met(removed.size(), 0.0);
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    const double now = time_at(c.time, s.state.steps_done) - 0.1;
    const auto pass = static_cast<std::size_t>(now / pass_time);
    const double y = s.state.place.X_WB.p.y(), since = now - pass_time * static_cast<double>(pass);
    if (since < 0.1 || since > 0.82 || y < -8e-3 || y > 10e-3) continue;
    removed[pass].add(y, s.state.ledger.removed.value());
    met[pass] += s.work.measures.sections[0].area * std::cos(back_rake);
  }
  if (kept != nullptr) *kept = s;
  std::vector<Pass> passes;
  for (std::size_t k = 0; k < removed.size(); ++k)
    passes.push_back({removed[k].value(), met[k] / removed[k].n});
  return passes;
}

/// The area of the groove of a face that removes all: that of its outline below the surface.
double whole_area() {
  const Case c = case_of({});
  const rock::FaceOutline face = rock::face_outline(c.bit.cutters[0], 0, c.bit.parts);
  double lowest = 1.0;
  for (const rock::Vec2& x : face.rim_F) lowest = std::min(lowest, x.y());
  rock::ConvexPolygon below;
  rock::clip(face.rim_F, {{0.0, -1.0}, lowest + depth / std::cos(back_rake)}, below);
  return rock::moments(below).area * std::cos(back_rake);
}

/// The first pass removes s A and leaves (1 - s) A to the second one.
struct Errors {
  double first, second, met;
};

Errors errors(double share, double edge, double step) {
  const double all = whole_area();
  const std::vector<Pass> p = passes_of({share, edge, step, 2});
  EXPECT_NEAR(p[0].met / all, 1.0, 1e-12);
  const Errors e{p[0].removed / all - share, p[1].removed / all - share * (1.0 - share),
                 p[1].met / all - (1.0 - share)};
  fmt::print("share {}, edge {:.1f} mm, step {:.1f} ms: removed {:+.1e} {:+.1e}, met {:+.1e}\n",
             share, 1e3 * edge, 1e3 * step, e.first, e.second, e.met);
  return e;
}

TEST(RemovalShare, of_a_groove_converges_to_its_share_of_the_area_in_step_and_mesh) {
  for (const double share : {0.3, 0.6})
    for (const double step : {4e-3, 2e-3, 1e-3, 0.5e-3}) {
      const Errors coarse = errors(share, 2e-3, step), fine = errors(share, 1e-3, step),
                   finest = errors(share, 0.5e-3, step);
      EXPECT_LT(std::abs(finest.met), 0.45 * std::abs(fine.met));
      EXPECT_LT(std::abs(fine.met), 0.45 * std::abs(coarse.met));
      EXPECT_LT(std::abs(finest.first), 1.5e-4);
      EXPECT_LT(std::abs(finest.second), 6e-5);
    }
}

TEST(RemovalShare, leaves_sound_rock) {
  Simulation s;
  passes_of({.share = 0.5, .passes = 2}, &s);
  expect_sound(s);
}

Case bit_b(std::vector<std::string> more, const std::string& file = "bit-b-3000psi") {
  more.emplace_back("rock.edge_length='3 mm'");
  return read_case(TDBD_SOURCE_DIR "/cases/" + file + ".toml", more);
}

std::vector<std::string> all_cutters(double share) {
  return {"bit.set.areas.a.names='cutter-*'",
          fmt::format("bit.set.areas.a.removal.share={}", share)};
}

Simulation drilled(const Case& c, int steps, int threads = 1) {
  const ThreadLimit limit(threads);
  Simulation s = start(c);
  for (int i = 0; i < steps; ++i) step(c, s);
  return s;
}

void expect_equal(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(mesh::positions_of(a.state.rock.surface), mesh::positions_of(b.state.rock.surface));
  EXPECT_EQ(a.state.rock.surface.triangles, b.state.rock.surface.triangles);
  EXPECT_EQ(a.state.ledger.removed_by_revolution, b.state.ledger.removed_by_revolution);
  EXPECT_EQ(a.work.loads.force_W, b.work.loads.force_W);
}

TEST(RemovalShare, of_1_changes_nothing) {
  expect_equal(drilled(bit_b({}), 60), drilled(bit_b(all_cutters(1.0)), 60));
}

TEST(RemovalShare, is_bitwise_the_same_on_two_threads) {
  const Case c = bit_b(all_cutters(0.5));
  expect_equal(drilled(c, 90, 1), drilled(c, 90, 2));
}

/// With wear steps, which prepare the bit again, parts that start late and rock that breaks out.
TEST(RemovalShare, continues_bitwise_from_a_copy_of_the_state) {
  std::vector<std::string> settings = all_cutters(0.5);
  for (const char* s : {"spalling={angle='70 deg', ahead_share=0.3}",
                        "spalling.up_to_pressure='1 GPa'", "wear.every_steps=7", "wear.from=0",
                        "bit.set.areas.b={blade=2, removal.from_time='20 ms'}"})
    settings.emplace_back(s);
  const Case c = bit_b(settings, "wear-bit-b");
  const Simulation s = drilled(c, 60);
  EXPECT_GT(s.state.wear->steps, 3);
  EXPECT_EQ(s.work.waits, Waits::none);
  EXPECT_GT(s.state.rock.left.size(), 20U);
  expect_sound(s);
  for (const int at : {15, 40}) {
    Simulation first = drilled(c, at);
    Simulation resumed = resume(c, first.state, first.statistics);
    for (int i = at; i < 60; ++i) step(c, resumed);
    expect_equal(s, resumed);
  }
}

/// Over the last revolution: the mean weight, and the volume that the faces met over the volume of a
/// hole of the bit's size.
struct Drilled {
  double weight = 0.0, met = 0.0;
};

Drilled last_revolution(const Case& c, long revolutions) {
  Simulation s = start(c);
  const long last = c.time.steps / revolutions;
  const double per_step = 1.0 / static_cast<double>(last);
  Drilled d;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    if (s.state.steps_done <= c.time.steps - last) continue;
    d.weight -= per_step * s.work.loads.force_W.z();
    for (const rock::Section& section : s.work.measures.sections)
      d.met += per_step * section.volume_rate;
  }
  d.met /= std::numbers::pi * c.bit.gage_radius * c.bit.gage_radius * c.motion.rate_of_penetration;
  return d;
}

/// In steady drilling every column of rock loses what the bit goes down, so that cutters with the
/// share s meet 1 / s of it. Cutters that overlap share it otherwise than at the rate 1 / s times as
/// high, so that the weight is only nearly the same.
TEST(RemovalShare, of_all_cutters_meets_the_hole_over_the_share) {
  constexpr double share = 0.5;
  std::vector<std::string> settings = all_cutters(share);
  settings.emplace_back("time.revolutions=6");
  const Drilled some = last_revolution(bit_b(settings), 6),
                all = last_revolution(
                    bit_b({"time.revolutions=6", "motion.rate_of_penetration='30 m/h'"}), 6);
  fmt::print("met over drilled: {:.4f} with the share {}, {:.4f} of all; weight {:.0f}, {:.0f} N\n",
             some.met, share, all.met, some.weight, all.weight);
  EXPECT_NEAR(some.met, 1.0 / share, 0.04);
  EXPECT_NEAR(all.met, 1.0, 0.015);
  EXPECT_NEAR(some.weight / all.weight, 1.0, 0.1);
}

/// One cutter deepens its groove, 8 mm in all, at a rate in m/h.
Case one_cutter(double share, double rate, double edge, double step) {
  const auto folder = write_one_cutter(share);
  const double turns = 8e-3 / (rate / 3600.0);
  return read_case(
      write_file(folder / "turns.toml",
                 fmt::format("[bit]\nfile = \"one.toml\"\n[rock]\nshape = \"flat\"\n"
                             "radius = 0.046\nedge_length = {}\nwall = 0.01\n"
                             "material = \"mancos-shale\"\npressure = \"3000 psi\"\n"
                             "[motion]\nkind = \"steady\"\nrotary_speed = \"60 rpm\"\n"
                             "rate_of_penetration = \"{} m/h\"\n[time]\nstep = {}\n"
                             "revolutions = {}\n[forces]\nlaw = \"hanson-hansen\"\n"
                             "A1 = 1.0\nA2 = 0.3\nA3 = \"18 deg\"\nA4 = 0.5\nA5 = 1.0\nA6 = 0.3\n",
                             edge, rate, step, turns)),
      {});
}

/// One cutter with the share s meets the area that it meets with the share 1 at the rate 1 / s times as
/// high, in the limit of step and mesh, and so needs that weight. (Its path is half as steep, which
/// changes the force by 0.3 %.)
TEST(RemovalShare, of_one_cutter_needs_the_weight_of_the_rate_over_the_share) {
  for (const auto& [wrong, edge, step] :
       {std::tuple(2e-2, 2e-3, 4e-3), std::tuple(1.2e-2, 1e-3, 2e-3),
        std::tuple(4e-3, 0.7e-3, 1e-3)}) {
    const Drilled some = last_revolution(one_cutter(0.5, 1.8, edge, step), 16),
                  all = last_revolution(one_cutter(1.0, 3.6, edge, step), 8);
    fmt::print("edge {:.1f} mm: met {:.4f} times as much, weight {:.2f} and {:.2f} N\n", 1e3 * edge,
               some.met / all.met, some.weight, all.weight);
    EXPECT_NEAR(some.met / all.met, 2.0, wrong);
    EXPECT_NEAR(some.weight / all.weight, 1.0, 0.02);
  }
}

}  // namespace
}  // namespace tdbd::simulation::removal_share_test
