#include "simulation/start/rock_start.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <string_view>
#include <system_error>
#include <utility>

#include "bit/cone/swept_parts.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "mesh/check/check.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/files.hpp"
#include "mesh/repair/repair.hpp"
#include "rock/start/borehole.hpp"
#include "rock/start/space_order.hpp"

namespace tdbd::simulation {
namespace {

constexpr std::string_view step_key = "tdbd step ", time_key = "tdbd time_s ",
                           hash_key = "tdbd case_hash ";

/// The comments among the first lines of a PLY header.
std::vector<std::string> header_comments(const std::filesystem::path& file) {
  constexpr int most_lines = 64;
  constexpr std::string_view comment = "comment ";
  std::ifstream in(file, std::ios::binary);
  std::vector<std::string> comments;
  std::string line;
  for (int n = 0; n < most_lines && std::getline(in, line) && line != "end_header"; ++n) {
    if (n == 0 && line != "ply") return {};
    if (line.starts_with(comment)) comments.push_back(line.substr(comment.size()));
  }
  return comments;
}

std::optional<std::string> value_of(const std::vector<std::string>& comments,
                                    std::string_view key) {
  for (const std::string& line : comments)
    if (line.starts_with(key)) return line.substr(key.size());
  return std::nullopt;
}

}  // namespace

std::vector<std::string> comments_of(const RockStamp& stamp) {
  return {mesh::unit_comment(mesh::LengthUnit{}), fmt::format("{}{}", step_key, stamp.step),
          fmt::format("{}{}", time_key, stamp.time),
          fmt::format("{}{}", hash_key, stamp.case_hash)};
}

std::optional<RockStamp> read_stamp(const std::filesystem::path& file) {
  std::error_code none;  // an unreadable file has no stamp; opening a pipe would block
  if (!std::filesystem::is_regular_file(file, none)) return std::nullopt;
  const std::vector<std::string> comments = header_comments(file);
  const auto step = value_of(comments, step_key), time = value_of(comments, time_key),
             hash = value_of(comments, hash_key);
  if (!step || !time || !hash) return std::nullopt;
  const std::optional<long> steps = csv_number<long>(*step);
  const std::optional<double> seconds = csv_number<double>(*time);
  if (!steps || !seconds) return std::nullopt;
  return RockStamp{*steps, *seconds, *hash};
}

void require_same_time(const Case& c) {
  if (c.time.first == 0) return;
  const std::optional<RockStamp> stamp = read_stamp(c.rock.file);
  constexpr double same = 1e-6;  // relative to a step: times are products with little rounding
  const double begin = time_at(c.time, c.time.first);
  if (!stamp || std::abs(stamp->time - begin) <= same * c.time.step) return;
  throw InputError(fmt::format(
      "{}: found {}, at t = {} s, expected {:.6g}: {} is the rock after step {}, at t = {} s (0 "
      "starts a new motion in this rock)",
      c.places.first_step, c.time.first, begin, stamp->time / c.time.step, c.rock.file, stamp->step,
      stamp->time));
}

namespace {

constexpr double bytes_per_triangle = 250.0;
constexpr double bytes_per_cell = 4.2;
constexpr double most_triangles = 7e8;  // three corners each, indexed by int
constexpr double most_cells = 2e9;      // indexed by int

double memory_of_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

bool fits_machine(const RockRequirements& need) {
  return need.triangles <= most_triangles && need.cells <= most_cells &&
         need.bytes <= memory_of_machine();
}

/// Area of the cylinder that the gage of the bit sweeps on its way down.
double area_of_new_wall(const Case& c, const mesh::Box& reach) {
  return 2.0 * std::numbers::pi * c.bit.gage_radius * reach.size().z();
}

}  // namespace

RockRequirements rock_requirements(double area, const mesh::Box& box_W, double edge_length) {
  constexpr double cell_over_edge = 2.0;
  RockRequirements need;
  need.triangles = area * 4.0 / std::numbers::sqrt3 / (edge_length * edge_length);
  need.cells = (box_W.size().array() / (cell_over_edge * edge_length) + 1.0).prod();
  need.bytes = bytes_per_triangle * need.triangles + bytes_per_cell * need.cells;
  return need;
}

double bytes_of_triangles(double triangles) { return bytes_per_triangle * triangles; }

RockRequirements new_wall_requirements(const Case& c) {
  const mesh::Box reach = reach_W(c);
  return rock_requirements(area_of_new_wall(c, reach), reach, c.rock.edge_length);
}

mesh::Box reach_W(const Case& c) {
  mesh::Box box;
  const double r = c.bit.gage_radius + c.motion.whirl.radius;
  const auto add = [&](const Vec3& p) {
    box.add(p - Vec3(r, r, 0.0));
    box.add(p + Vec3(r, r, 0.0));
  };
  for (const long steps : {c.time.first, c.time.steps})
    add(pose_at(c.motion, time_at(c.time, steps)).p);
  for (const PathPoint& p : c.motion.path) add(p.p_WB);
  return box;
}

/// Rock far from the bit needs cells for the whole way to it. No edge length helps then.
static void require_near(const Case& c, const mesh::Box& rock, const mesh::Box& bit) {
  constexpr double bits = 10.0;
  const Vec3 gap = (bit.lo - rock.hi).cwiseMax(rock.lo - bit.hi).cwiseMax(0.0);
  if (gap.norm() <= bits * 2.0 * c.bit.gage_radius) return;
  const Vec3 r = 0.5 * (rock.lo + rock.hi), b = 0.5 * (bit.lo + bit.hi);
  const bool of_file = c.rock.shape == RockShape::file;
  throw InputError(fmt::format(
      "{}: found rock {:.4g} m from the bit: its middle is at ({:.4g}, {:.4g}, {:.4g}) m, that of "
      "the bit's way at ({:.4g}, {:.4g}, {:.4g}) m, expected rock that the bit can reach: "
      "correct rock.unit, move the rock, or start the bit elsewhere (motion.start)",
      of_file ? c.places.file : c.places.motion, gap.norm(), r.x(), r.y(), r.z(), b.x(), b.y(),
      b.z()));
}

void require_memory(const Case& c, double area, mesh::Box box_W) {
  const mesh::Box reach = reach_W(c), rock_W = box_W;
  box_W.add(reach.lo);
  box_W.add(reach.hi);
  area += area_of_new_wall(c, reach);
  const RockRequirements need = rock_requirements(area, box_W, c.rock.edge_length);
  if (fits_machine(need)) return;
  require_near(c, rock_W, reach);
  double edge = c.rock.edge_length;
  constexpr double finest_step = 1.1;
  for (int k = 0; k < 400 && !fits_machine(rock_requirements(area, box_W, edge)); ++k)
    edge *= finest_step;
  throw InputError(fmt::format(
      "{}: found {} m, which makes {:.1e} triangles and {:.1e} cells of rock on a way of {:.3g} m "
      "and needs {:.3g} GB, expected at most {:.3g} GB (this machine's memory), {:.0e} triangles "
      "and {:.0e} cells: {:.2g} m is enough",
      c.places.edge_length, c.rock.edge_length, need.triangles, need.cells, reach.size().norm(),
      1e-9 * need.bytes, 1e-9 * memory_of_machine(), most_triangles, most_cells, edge));
}

namespace {

/// Distance from the origin of the bit to the farthest cutting point, m.
double cutting_radius(const bit::Bit& bit) {
  double farthest = 0.0;
  for (const bit::Part& part : bit.parts)
    if (part.cutting == bit::Cutting::cuts)
      for (const Vec3& x_P : part.mesh_P.positions)
        farthest = std::max(farthest, (part.X_BP * x_P).norm());
  return farthest;
}

mesh::Box box_of(const mesh::Surface& rock) {
  mesh::Box box;
  for (const mesh::Triangle& t : rock.triangles)
    if (t[0] >= 0)
      for (const int v : t) box.add(rock.position(v));
  return box;
}

}  // namespace

double gap_along_path(const Case& c, const mesh::Surface& rock) {
  const Vec3 around = Vec3::Constant(cutting_radius(c.bit));
  const mesh::Box way = reach_W(c), there = box_of(rock);
  const Vec3 below = there.lo - (way.hi + around), above = (way.lo - around) - there.hi;
  return below.cwiseMax(above).cwiseMax(0.0).norm();
}

std::vector<CaseWarning> reach_warnings(const Case& c, const mesh::Surface& rock) {
  std::vector<CaseWarning> warnings;
  if (const double gap = gap_along_path(c, rock); gap > 0.0)
    warnings.push_back(
        {c.places.motion, std::string(Motion::table.name),
         fmt::format("the bit stays {:.3g} m or more from the rock and cuts nothing", gap)});
  constexpr double narrowest = 0.5, widest = 50.0;  // of the bit's diameter
  const mesh::Box box = box_of(rock);
  const double width = std::max(box.size().x(), box.size().y()), bit = 2.0 * c.bit.gage_radius;
  if (c.rock.shape == RockShape::file && (width < narrowest * bit || width > widest * bit))
    warnings.push_back(
        {c.rock.file, "rock.unit",
         fmt::format("the rock is {:.4g} mm wide with rock.unit = {} m, and the bit {:.4g} mm: is "
                     "the unit right?",
                     1e3 * width, c.rock.unit, 1e3 * bit)});
  return warnings;
}

namespace {

[[noreturn]] void refuse(const Case& c, const std::string& found, const std::string& expected) {
  throw InputError(fmt::format("{}: found {}, expected {}", c.rock.file, found, expected));
}

/// Checks for self-intersections, which would leave undefined which side is rock. Performed once;
/// takes some seconds for a million triangles.
void require_no_intersections(const Case& c, const std::string& place,
                              const mesh::TriangleMesh& m) {
  if (c.rock.intersections == IntersectionCheck::none) return;
  const auto pairs = mesh::self_intersections(m);
  if (pairs.empty()) return;
  throw InputError(fmt::format(
      "{}: found {} pairs of triangles that intersect, the first {} and triangle {}, expected a "
      "surface that does not intersect itself (rock.intersection_check = \"off\" permits it)",
      place, pairs.size(), mesh::place_of_triangle(m, pairs.front().first), pairs.front().second));
}

/// The larger side of a box as seen along z, m.
double width_of(const mesh::Box& box) { return std::max(box.size().x(), box.size().y()); }

/// Units in which the edges of a mesh would be near edge_length: ": is it in m (rock.unit = \"1
/// m\": edges of 2 mm, 250 mm wide)?".
std::string unit_question(const Case& c, double edge, double width) {
  constexpr double factor = 5.0;
  std::string guesses;
  for (const char* name : {"mm", "cm", "in", "m"}) {
    const double scale = mesh::length_unit(name).metres / c.rock.unit;
    if (scale * edge * factor < c.rock.edge_length || scale * edge > factor * c.rock.edge_length)
      continue;
    guesses += fmt::format("{}in {} (rock.unit = \"1 {}\": edges of {:.3g} mm, {:.3g} mm wide)",
                           guesses.empty() ? "" : ", or ", name, name, 1e3 * scale * edge,
                           1e3 * scale * width);
  }
  return guesses.empty() ? "" : ": is it " + guesses + "?";
}

/// Checks that the edges are not far from edge_length, which would suggest a wrong unit.
void require_plausible_edges(const Case& c, const mesh::TriangleMesh& m) {
  constexpr double factor = 20.0;
  const double triangles = static_cast<double>(m.triangles.size());
  const double edge = std::sqrt(mesh::area(m) / triangles * 4.0 / std::numbers::sqrt3);
  const double width = width_of(mesh::bounding_box(m));
  if (edge * factor < c.rock.edge_length || edge > factor * c.rock.edge_length)
    refuse(c,
           fmt::format("edges of about {:.3g} mm with rock.unit = {} m, in a mesh {:.4g} mm wide",
                       1e3 * edge, c.rock.unit, 1e3 * width),
           fmt::format("edges near rock.edge_length, {:.3g} mm{}", 1e3 * c.rock.edge_length,
                       unit_question(c, edge, width)));
}

/// Checks that the normals point out of the rock, which is upwards on average.
void require_facing_up(const Case& c, const mesh::TriangleMesh& m) {
  if (mesh::faces_down(m))
    refuse(c, "all facets flipped (they face down, into the rock)",
           fmt::format("facets that face up (z down): {}", mesh::upside_down_question));
}

/// "a; b" from "a\nb\n".
std::string in_one_line(const std::string& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += lines[i] != '\n' ? std::string(1, lines[i]) : i + 1 < lines.size() ? "; " : "";
  return text;
}

mesh::Box box_of(const std::vector<rock::MeridianPoint>& curve) {
  mesh::Box box;
  for (const rock::MeridianPoint& p : curve) {
    box.add({-p.r, -p.r, p.z});
    box.add({p.r, p.r, p.z});
  }
  return box;
}

double area_of(const std::vector<rock::MeridianPoint>& curve) {
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i)
    area += std::numbers::pi * (curve[i - 1].r + curve[i].r) *
            std::hypot(curve[i].r - curve[i - 1].r, curve[i].z - curve[i - 1].z);
  return area;
}

std::vector<rock::MeridianPoint> conforming(const Case& c) {
  const double spacing = 0.25 * c.rock.edge_length;
  std::vector<rock::MeridianPoint> curve;
  for (const bit::ProfilePoint& p : bit::exposure_profile(bit::swept_parts(c.bit), spacing))
    curve.push_back({p.r, p.z});
  return rock::with_wall(std::move(curve), c.rock.wall);
}

/// A flat bottom at the depth of the lowest cutting point of the bit over a revolution of its
/// cones.
std::vector<rock::MeridianPoint> flat(const Case& c) {
  double lowest = -std::numeric_limits<double>::infinity();
  for (const bit::Part& p : bit::swept_parts(c.bit))
    for (const Vec3& x_P : p.mesh_P.positions) lowest = std::max(lowest, (p.X_BP * x_P).z());
  const double radius = c.rock.radius > 0.0 ? c.rock.radius : c.bit.gage_radius;
  return rock::flat_bottom(radius, lowest, c.rock.wall);
}

std::vector<rock::MeridianPoint> meridian(const Case& c) {
  switch (c.rock.shape) {
    case RockShape::conforming:
      return conforming(c);
    case RockShape::flat:
    case RockShape::rough:
      return flat(c);
    case RockShape::profile:
    case RockShape::file:
      break;
  }
  return c.rock.profile;
}

/// A meridian from the case may intersect itself and is checked.
StartSurface of_revolution(const Case& c) {
  constexpr double cube_over_edge = 8.0;
  const std::vector<rock::MeridianPoint> curve = meridian(c);
  StartSurface start{{}, area_of(curve), box_of(curve)};
  require_memory(c, start.area, start.box_W);
  mesh::TriangleMesh m = rock::borehole(curve, c.rock.edge_length);
  if (c.rock.shape == RockShape::rough) rock::roughen_bottom(m, c.rock.roughness);
  if (c.rock.shape == RockShape::profile) require_no_intersections(c, c.places.profile, m);
  start.surface =
      mesh::make_surface(rock::in_order_of_space(m, cube_over_edge * c.rock.edge_length));
  return start;
}

/// The surface keeps the numbering of the file, so a continued run equals an uninterrupted one.
StartSurface from_file(const Case& c) {
  require_same_time(c);
  const mesh::TriangleMesh m = mesh::read_mesh(c.rock.file, c.rock.unit);
  const auto defects = mesh::check_surface(m);
  if (!defects.empty())
    refuse(c, in_one_line(mesh::describe(defects, 8)),
           "one open, consistently oriented surface (tdbd mesh --sheet lists its holes)");
  require_facing_up(c, m);
  require_plausible_edges(c, m);
  StartSurface start{{}, mesh::area(m), mesh::bounding_box(m)};
  require_memory(c, start.area, start.box_W);
  require_no_intersections(c, c.rock.file, m);
  start.surface = mesh::make_surface(m);
  return start;
}

}  // namespace

StartSurface start_surface(const Case& c) {
  return c.rock.shape == RockShape::file ? from_file(c) : of_revolution(c);
}

std::string start_surface_key(const Case& c) {
  const RockStart& r = c.rock;
  if (r.shape == RockShape::file) return "";
  std::string key = fmt::format("{} {} {} {} {} {} {} {} {}", c.bit_hash, static_cast<int>(r.shape),
                                r.edge_length, r.wall, r.radius, r.roughness.amplitude,
                                r.roughness.correlation_length, r.roughness.seed,
                                static_cast<int>(r.intersections));
  for (const rock::MeridianPoint& p : r.profile) key += fmt::format(" {} {}", p.r, p.z);
  return key;
}

rock::Rock start_rock(const Case& c) { return start_rock(c, start_surface(c)); }

/// Memory is checked again, because another case with the same surface may have a longer path.
rock::Rock start_rock(const Case& c, StartSurface start) {
  require_memory(c, start.area, start.box_W);
  return indexed_rock(c, std::move(start.surface));
}

rock::Rock indexed_rock(const Case& c, mesh::Surface surface) {
  constexpr double cell_over_edge = 2.0;
  return rock::make_rock(std::move(surface), cell_over_edge * c.rock.edge_length, reach_W(c));
}

}  // namespace tdbd::simulation
