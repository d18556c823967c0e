#include <algorithm>
#include <array>
#include <numbers>

#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "core/tolerance.hpp"
#include "reference/mesh/self_intersections.hpp"

/// Claims of chapter 4 on motions: whatever the bit does, the rock follows.
namespace tdbd::claims::rock_motion_test {

constexpr double pi = std::numbers::pi;

/// What every motion must leave: a closed ledger, no vertex so deep inside the bit that it would count
/// as swept, no triangles that intersect.
void record_sound(const std::string& claim, const std::string& motion, const simulation::Case& c,
                  const simulation::Simulation& s) {
  record_bound(claim, motion + ": defect of the volume ledger, relative",
               simulation::ledger_defect(s), "1", tolerance::ledger);
  record_bound(
      claim, motion + ": pairs of triangles that intersect",
      static_cast<double>(reference::self_intersecting_pairs(mesh::compact(s.state.rock.surface))),
      "1", 0.0);
  record_bound("chapter4/vertices-outside",
               motion + ": deepest rock vertex in a cutting part, over the bit's diameter",
               deepest_inside(c, s) / (2.0 * c.bit.gage_radius), "1", tolerance::swept);
}

/// Bits whose motions are asked, and the cases in which they drill.
struct Driller {
  const char* name;
  const char* file;
  const char* edge_length;
};
constexpr Driller bit_b{"bit B", "bit-b-steady", "3 mm"};
constexpr std::array drillers{bit_b, Driller{"bit A", "bit-a-steady", "3 mm"},
                              Driller{"bit C", "bit-c-steady", "3 mm"},
                              Driller{"bit R", "bit-r-steady", "4 mm"}};

simulation::Case whirling(const Driller& d, const std::string& sense) {
  return rock_case(d.file,
                   {fmt::format("rock.edge_length='{}'", d.edge_length), "time.revolutions=2",
                    "time.step='2 ms'", "motion.kind='whirl'", "motion.whirl.radius='1 mm'",
                    "motion.whirl.frequency='360 rpm'", "motion.whirl.sense='" + sense + "'"});
}

/// Largest distance of bottom vertices from the axis of space, m.
double hole_radius(const simulation::Simulation& s) {
  double r = 0.0;
  for (int v = 0; v < s.state.rock.surface.vertex_slots(); ++v)
    if (s.state.rock.surface.is_alive(v))
      r = std::max(r, s.state.rock.surface.position(v).head<2>().norm());
  return r;
}

/// `room`: of the hole's radius, relative.
void follow_whirl(const Driller& d, const char* sense, double room) {
  const simulation::Case c = until_an_update(whirling(d, sense));
  const simulation::Simulation s = drilled(c);
  const std::string motion = fmt::format("{}, {} whirl of 1 mm, 2 revolutions", d.name, sense);
  record_sound("chapter4/whirl", motion, c, s);
  if (c.rock.shape == simulation::RockShape::conforming)  // else the wall is not yet drilled
    record_near("chapter4/whirl", motion + ": radius of the hole over that of gage and whirl",
                hole_radius(s) / (c.bit.gage_radius + c.motion.whirl.radius), 1.0, room);
}

TEST(RockMotion, follows_forward_whirl) { follow_whirl(bit_b, "forward", 4e-5); }

TEST(RockMotion, follows_backward_whirl_of_every_bit) {
  for (const Driller& d : drillers) follow_whirl(d, "backward", 3e-4);
}

/// Rows of a path: down and turning, with what each motion does beside.
template <class Beside>
simulation::Case along_path(const Driller& d, double seconds, const Beside& beside) {
  constexpr double turn = 4.0 * pi, step = 0.025;  // rad/s, s
  simulation::Case c =
      rock_case(d.file, {fmt::format("rock.edge_length='{}'", d.edge_length), "rock.wall='60 mm'",
                         "time.revolutions=1", "time.step='2.5 ms'"});
  c.motion.kind = simulation::MotionKind::table;
  const int rows = static_cast<int>(seconds / step);
  c.motion.path.reserve(static_cast<std::size_t>(rows) + 1);
  for (int k = 0; k <= rows; ++k) {
    const double t = step * k;
    simulation::PathPoint p{t, Vec3::Zero(), Vec3(0, 0, std::remainder(turn * t, 2.0 * pi))};
    beside(t / seconds, p);
    c.motion.path.push_back(p);
  }
  simulation::sum_turns(c.motion.path);
  c.time.steps = static_cast<long>(seconds / c.time.step);
  return until_an_update(c);
}

TEST(RockMotion, follows_every_bit_that_cuts_sideways) {
  for (const Driller& d : drillers) {
    const simulation::Case c = along_path(
        d, 0.5, [](double x, simulation::PathPoint& p) { p.p_WB = Vec3(6e-3 * x, 0.0, 3e-3 * x); });
    record_sound("chapter4/general-motion",
                 fmt::format("{}, 6 mm sideways and 3 mm down in a revolution", d.name), c,
                 drilled(c));
  }
}

TEST(RockMotion, follows_a_bit_that_comes_back_and_reams) {
  const simulation::Case c = along_path(bit_b, 1.0, [](double x, simulation::PathPoint& p) {
    p.p_WB = Vec3(0.0, 2e-3 * x, 8e-3 * std::sin(3.0 * pi * x) + 4e-3 * x);
  });
  record_sound("chapter4/general-motion",
               "bit B, down 8 mm, back up and down again 2 mm beside, 2 revolutions", c,
               drilled(c));
}

}  // namespace tdbd::claims::rock_motion_test
