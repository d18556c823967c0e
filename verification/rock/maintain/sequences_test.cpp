#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <ostream>

#include "mesh/files/files.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/maintain/operations.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/core/temporary_folder.hpp"
#include "verification/rock/cut/cutting_scene.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

/// Lists of commands on one rock, whose promises are checked after each. A list that breaks one
/// shrinks to the shortest that does, and is printed.
namespace tdbd::rock::sequences_test {

enum class Kind { cut, maintain, collapse, bisect, flip, smooth, reload, count };

/// Numbers mean what the kind makes of them.
struct Command {
  Kind kind = Kind::cut;
  int pick = 0;                 ///< cut: shape of the tool; single operations: an edge
  double size = 0.2;            ///< cut: of the tool; else: edge length, less 0.15
  double quality = 0.1;         ///< maintain: worst quality
  double outwards = 0.0;        ///< cut: angle of the update direction against straight down
  Vec3 place_W = Vec3::Zero();  ///< cut: the tool's centre at the start
  Vec3 path_W = Vec3::Zero();   ///< cut: how far it goes
};

std::string in_words(const Vec3& x) { return fmt::format("({}, {}, {})", x.x(), x.y(), x.z()); }

// NOLINTNEXTLINE(readability-identifier-naming): RapidCheck's name
void showValue(const Command& c, std::ostream& out) {
  switch (c.kind) {
    case Kind::cut:
      out << fmt::format("cut with shape {} of {} at {} along {}, outwards {}", c.pick % 3, c.size,
                         in_words(c.place_W), in_words(c.path_W), c.outwards);
      break;
    case Kind::maintain:
      out << fmt::format("maintain at edges of {}, quality {}", c.size + 0.15, c.quality);
      break;
    case Kind::collapse:
      out << fmt::format("collapse edge {} at edges of {}", c.pick, c.size + 0.15);
      break;
    case Kind::bisect:
      out << fmt::format("bisect edge {} at edges of {}", c.pick, c.size + 0.15);
      break;
    case Kind::flip:
      out << fmt::format("flip edge {} at edges of {}", c.pick, c.size + 0.15);
      break;
    case Kind::smooth:
      out << fmt::format("smooth at edge {} at edges of {}", c.pick, c.size + 0.15);
      break;
    default:
      out << "save and load";
  }
}

/// `outwards`: the largest angle of an update direction, rad.
rc::Gen<Command> command(double outwards) {
  return rc::gen::build<Command>(
      rc::gen::set(&Command::kind,
                   rc::gen::map(battery::integer(0, static_cast<int>(Kind::count) - 1),
                                [](int k) { return static_cast<Kind>(k); })),
      rc::gen::set(&Command::pick, battery::integer(0, 5000)),
      rc::gen::set(&Command::size, battery::number(0.08, 0.3)),
      rc::gen::set(&Command::quality, battery::number(0.0, 0.3)),
      rc::gen::set(&Command::outwards, battery::number(0.0, outwards)),
      rc::gen::set(&Command::place_W, battery::point(0.8)),
      rc::gen::set(&Command::path_W, battery::point(0.15)));
}

/// The rock, and what the ledger should say.
struct Run {
  Rock rock;
  double change = 0.0;  ///< m3 of hole gained in all
};

CuttingBit tool(const Command& c) {
  bit::Part p;
  p.name = "tool";
  p.group = 0;
  const Vec3 half = c.size * Vec3(1.0, 0.5, 0.7);
  if (c.pick % 3 == 0) p.mesh_P = battery::box(-half, half);
  if (c.pick % 3 == 1) p.mesh_P = battery::cylinder(c.size, 0.5 * c.size, 12);
  if (c.pick % 3 == 2) p.mesh_P = battery::sphere(c.size, 1);
  p.update_direction_B = Vec3(std::sin(c.outwards), 0.0, std::cos(c.outwards));
  bit::Bit bit;
  bit.parts.push_back(std::move(p));
  return prepare_cutting_bit(bit);
}

/// M7 of a cut: what is not listed as touched has the same bits.
void cut(Run& run, const Command& c) {
  const Rock before = run.rock;
  CutWorkspace work;
  CutReport report;
  Vec3 from_W = c.place_W;
  from_W.z() *= 0.25;
  cut_rock(run.rock, tool(c), {Mat3::Identity(), from_W}, {Mat3::Identity(), from_W + c.path_W},
           work, report);
  run.change += report.removed;
  for (int v = 0; v < before.surface.vertex_slots(); ++v)
    if (!run.rock.touched[v]) RC_ASSERT(run.rock.surface.position(v) == before.surface.position(v));
}

MaintenanceLimits limits_of(const Command& c) {
  MaintenanceLimits limits = bare_limits_for(c.size + 0.15);  // of rock with edges of 0.33 and more
  limits.worst_quality = c.quality;
  limits.flip_quality = limits.smooth_quality = 3.0 * c.quality;
  limits.smoothing = c.pick % 2 == 0 ? Smoothing::off : Smoothing::tangential;
  return limits;
}

void maintain(Run& run, const Command& c) {
  const Rock before = run.rock;
  MaintenanceWorkspace work;
  MaintenanceReport report;
  maintain(run.rock, limits_of(c), work, report);
  run.change += report.volume_change;
  RC_ASSERT(describe(check_locality(before, run.rock.surface)) == "");
}

/// A living corner; its edge is the one that it faces.
int corner(const mesh::Surface& s, int pick) {
  int c = pick % (3 * s.triangle_slots());
  while (!s.triangle_is_alive(c / 3)) c = (c + 1) % (3 * s.triangle_slots());
  return c;
}

/// One guarded operation on one edge. M4, M7: what it may do to normals, and where.
void operate(Run& run, const Command& c) {
  Rock before = run.rock;
  const int at = corner(run.rock.surface, c.pick);
  const int a = run.rock.surface.vertex(mesh::next_corner(at)),
            b = run.rock.surface.vertex(mesh::previous_corner(at));
  std::vector<int> ring;
  SurfaceDrift drift;
  MaintenanceReport report;
  MaintenanceLimits limits = limits_of(c);
  limits.longest_edge *= c.kind == Kind::bisect ? 0.25 : 1.0;
  if (c.kind == Kind::bisect) bisect_edge(run.rock, a, b, limits, ring, report);
  if (c.kind == Kind::collapse) try_collapse(run.rock, a, b, limits, ring, drift, report);
  if (c.kind == Kind::flip) try_flip(run.rock, at, limits, drift, report);
  if (c.kind == Kind::smooth) try_smooth(run.rock, a, limits, drift, report);
  run.change += report.volume_change;
  before.touched.assign(before.touched.size(), 0);
  before.touched[a] = before.touched[b] = 1;
  RC_ASSERT(describe(check_locality(before, run.rock.surface)) == "");
  RC_ASSERT(describe(check_normals(before.surface, run.rock.surface)) == "");
  RC_ASSERT(describe(check_distance(before.surface, run.rock.surface, limits)) == "");
}

/// Through a file and back: the same bits, slots without gaps.
void reload(Run& run) {
  const std::string path = temporary_folder() + "rock.ply";
  std::vector<int> slots;
  const mesh::TriangleMesh saved = mesh::compact(run.rock.surface, &slots);
  mesh::write_mesh(path, saved);
  const mesh::TriangleMesh loaded = mesh::read_mesh(path, 1.0);
  RC_ASSERT(loaded.positions == saved.positions);
  RC_ASSERT(loaded.triangles == saved.triangles);
  Rock rock = make_rock(mesh::make_surface(loaded), 0.2, mesh::bounding_box(loaded));
  for (std::size_t v = 0; v < slots.size(); ++v) {
    if (run.rock.touched[slots[v]]) touch(rock, static_cast<int>(v));
    rock.last_part[v] = run.rock.last_part[slots[v]];
    RC_ASSERT(rock.surface.is_boundary(static_cast<int>(v)) ==
              run.rock.surface.is_boundary(slots[v]));
  }
  run.rock = std::move(rock);
}

void carry_out(Run& run, const Command& c) {
  switch (c.kind) {
    case Kind::cut:
      return cut(run, c);
    case Kind::maintain:
      return maintain(run, c);
    case Kind::reload:
      return reload(run);
    default:
      return operate(run, c);
  }
}

enum class Folds { refused, allowed };

/// M1 and M5 after each command, M4 too where cutting makes no folds of its own.
void check(double outwards, Folds folds) {
  const auto commands =
      *rc::gen::scale(0.5, rc::gen::container<std::vector<Command>>(command(outwards)));
  const mesh::TriangleMesh m =
      battery::bumpy_rock(1.5, 9, 0.2, static_cast<std::uint64_t>(*battery::integer(0, 1000)));
  const mesh::Surface first = mesh::make_surface(m);
  Run run{make_rock(first, 0.2, mesh::bounding_box(m))};
  for (const Command& c : commands) {
    carry_out(run, c);
    RC_ASSERT(describe(check_disc(run.rock)) == "");
    RC_ASSERT(describe(check_ledger(first, run.rock.surface, run.change)) == "");
    if (folds == Folds::refused)
      RC_ASSERT(reference::self_intersecting_pairs(mesh::compact(run.rock.surface)) == 0U);
  }
}

RC_GTEST_PROP(Sequences, keep_disc_ledger_and_untouched_rock, ()) { check(1.2, Folds::allowed); }

/// Rock that is moved straight down stays a height field, which has no folds (M4).
RC_GTEST_PROP(Sequences, straight_down_never_fold_the_rock, ()) { check(0.0, Folds::refused); }

/// A list that was found: a flip at a touched vertex, then a collapse that puts the flipped triangle
/// there back. What changed lies behind it.
TEST(Sequences, change_rock_behind_a_triangle_that_is_put_back) {
  const mesh::TriangleMesh m = battery::bumpy_rock(1.5, 9, 0.2, 455);
  sequences_test::Run run{make_rock(mesh::make_surface(m), 0.2, mesh::bounding_box(m))};
  const auto at_edges = [](double length) { return length - 0.15; };
  Command c{.kind = Kind::cut, .size = 0.142};
  c.place_W = {-0.358, -0.064, 0.564};
  c.path_W = {0.0, 0.0, -0.006};
  carry_out(run, c);
  carry_out(run, {.kind = Kind::bisect, .pick = 2702, .size = at_edges(0.23)});
  carry_out(run, {.kind = Kind::maintain, .size = at_edges(0.231), .quality = 0.0});
  carry_out(run, {.kind = Kind::collapse, .pick = 3691, .size = at_edges(0.265)});
  carry_out(run, {.kind = Kind::maintain, .size = at_edges(0.379), .quality = 0.279});
}

}  // namespace tdbd::rock::sequences_test
