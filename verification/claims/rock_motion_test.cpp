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

/// Where the vertices that the last step moved are with the bit at its end.
struct Moved {
  long count = 0, beside = 0;  ///< beside: off the bit's surface by more than 1e-9 of its diameter
  double farthest = 0.0;       ///< m, from the bit
  double travel = 0.0;         ///< m, of the bit in that step, where it moves fastest
};

/// Distance of a place from the nearest part, m: from the planes of a part that it is beyond. Negative inside.
double distance_from_bit(const simulation::Simulation& s, const Pose& X_WB, const Vec3& x_W) {
  double nearest = INFINITY;
  for (const rock::CuttingGroup& g : s.work.cutting.groups) {
    const Vec3 x_P = inverse(X_WB * g.X_BP1) * x_W;
    for (const rock::CuttingPart& p : g.parts)
      nearest = std::min(nearest, -rock::depth_inside(p, x_P));
  }
  return nearest;
}

/// How far the corners of the boxes around the parts went in a step, m.
double travel(const simulation::Simulation& s, const Pose& X_WB0, const Pose& X_WB1) {
  double most = 0.0;
  for (const rock::CuttingGroup& g : s.work.cutting.groups)
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 x_P;
      for (int i = 0; i < 3; ++i) x_P[i] = (corner >> i & 1) != 0 ? g.box_P.hi[i] : g.box_P.lo[i];
      most = std::max(most, (X_WB1 * g.X_BP1 * x_P - X_WB0 * g.X_BP * x_P).norm());
    }
  return most;
}

/// Carries out the case's last step.
Moved last_step(const simulation::Case& c, simulation::Simulation& s) {
  const mesh::Surface before = s.state.rock.surface;
  const auto pose = [&] {
    return pose_at(c.motion, c.time.step * static_cast<double>(s.state.steps_done));
  };
  const Pose X_WB0 = pose();
  simulation::step(c, s);
  const Pose X_WB = pose();
  Moved m;
  m.travel = travel(s, X_WB0, X_WB);
  for (int v = 0; v < before.vertex_slots(); ++v) {
    if (!before.is_alive(v) || before.position(v) == s.state.rock.surface.position(v)) continue;
    const double distance = distance_from_bit(s, X_WB, s.state.rock.surface.position(v));
    ++m.count;
    m.beside += distance > 1e-9 * 2.0 * c.bit.gage_radius;
    m.farthest = std::max(m.farthest, distance);
  }
  return m;
}

/// The thesis moves vertices onto the bit. In TDBD a vertex that a part passed within the step stays on
/// the surface that the part swept, so it may be beside the bit at the step's end.
void record_moved(const std::string& motion, const Moved& m) {
  EXPECT_GT(m.count, 10) << motion;
  battery::record({"chapter4/vertices-outside",
                   motion + ": share of the vertices moved in the last step that are beside the "
                            "bit at its end, not on it",
                   static_cast<double>(m.beside) / static_cast<double>(m.count), "1",
                   "0, did vertices move onto the bit and not onto what it swept",
                   m.beside == 0 ? battery::Verdict::holds : battery::Verdict::holds_with_limits});
  EXPECT_LE(m.farthest, m.travel) << motion;
  battery::record({"chapter4/vertices-outside",
                   motion + ": how far the farthest of them is from the bit, over the bit's travel "
                            "in that step",
                   m.farthest / m.travel, "1",
                   "<= 1; wide: by geometry, whatever the share of the travel",
                   m.farthest <= m.travel ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// Drills a case and records what every motion must leave: a closed ledger, no vertex so deep inside the
/// bit that it would count as swept, no triangles that intersect.
simulation::Simulation record_sound(const std::string& claim, const std::string& motion,
                                    const simulation::Case& c) {
  simulation::Simulation s = simulation::start(c);
  while (s.state.steps_done + 1 < c.time.steps) simulation::step(c, s);
  record_moved(motion, last_step(c, s));
  record_bound(claim, motion + ": defect of the volume ledger, relative",
               simulation::ledger_defect(s), "1", tolerance::ledger);
  record_bound(
      claim, motion + ": pairs of triangles that intersect",
      static_cast<double>(reference::self_intersecting_pairs(mesh::compact(s.state.rock.surface))),
      "1", 0.0);
  record_bound("chapter4/vertices-outside",
               motion + ": deepest rock vertex in a cutting part, over the bit's diameter",
               deepest_inside(c, s) / (2.0 * c.bit.gage_radius), "1", tolerance::swept);
  return s;
}

/// Bits that are moved, and the cases in which they drill.
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
  const std::string motion = fmt::format("{}, {} whirl of 1 mm, 2 revolutions", d.name, sense);
  const simulation::Simulation s = record_sound("chapter4/whirl", motion, c);
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
                 fmt::format("{}, 6 mm sideways and 3 mm down in a revolution", d.name), c);
  }
}

TEST(RockMotion, follows_a_bit_that_comes_back_and_reams) {
  const simulation::Case c = along_path(bit_b, 1.0, [](double x, simulation::PathPoint& p) {
    p.p_WB = Vec3(0.0, 2e-3 * x, 8e-3 * std::sin(3.0 * pi * x) + 4e-3 * x);
  });
  record_sound("chapter4/general-motion",
               "bit B, down 8 mm, back up and down again 2 mm beside, 2 revolutions", c);
}

}  // namespace tdbd::claims::rock_motion_test
