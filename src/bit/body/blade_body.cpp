#include "bit/body/blade_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/types.hpp"

namespace tdbd::bit {
namespace {

/// Near the axis, a blade's front wall, back edge and back wall take at most these fractions of the
/// angle to the next blade's front, so that the columns of the mesh keep their order.
constexpr double front_wall_share = 0.25, back_edge_share = 0.6, back_wall_share = 0.7;

/// Number of mesh steps across each piece of a cell. A cell extends from a blade's front to the
/// next.
struct CellSteps {
  int front_wall = 1, slot = 1, back_wall = 1, top = 1;
};

int steps_over(double length, double edge) {
  return std::max(1, static_cast<int>(std::ceil(length / edge - 1e-9)));
}

double angle_across(double y, double r) { return std::asin(std::clamp(y / r, -1.0, 1.0)); }

/// The angles of one cell at one ring, all ahead of the blade's front: the end of the front wall,
/// the beginnings of the next blade's back wall and top, and the next front.
struct Cell {
  double front = 0.0, foot = 0.0, next_foot = 0.0, next_edge = 0.0, next_front = 0.0;
};

Cell cell_at(const BladeShape& shape, std::size_t k, const MeridianNode& at) {
  const BladeStrip& blade = shape.blades[k];
  const BladeStrip& next = shape.blades[(k + 1) % shape.blades.size()];
  const double r = at.top.r;
  Cell cell;
  cell.front = front_at(blade, at.s);
  cell.next_front = front_at(next, at.s) + (k + 1 == shape.blades.size() ? full_turn : 0.0);
  const double gap = cell.next_front - cell.front;
  cell.foot = cell.front + std::min(angle_across(shape.wall, r), front_wall_share * gap);
  cell.next_edge = cell.next_front - std::min(angle_across(next.width, r), back_edge_share * gap);
  cell.next_foot =
      cell.next_front - std::min(angle_across(next.width + shape.wall, r), back_wall_share * gap);
  return cell;
}

std::vector<CellSteps> cell_steps(const BladeShape& shape, double edge) {
  const MeridianNode& gage = shape.meridian.back();
  std::vector<CellSteps> steps;
  for (std::size_t k = 0; k < shape.blades.size(); ++k) {
    const Cell c = cell_at(shape, k, gage);
    const double r = gage.top.r;
    steps.push_back({steps_over(shape.wall, edge), steps_over(r * (c.next_foot - c.foot), edge),
                     steps_over(shape.wall, edge),
                     steps_over(shape.blades[(k + 1) % shape.blades.size()].width, edge)});
  }
  return steps;
}

void add_steps(double from, double to, int steps, std::vector<double>& azimuths) {
  for (int i = 0; i < steps; ++i)
    azimuths.push_back(std::lerp(from, to, static_cast<double>(i) / steps));
}

/// Azimuths of a ring's vertices, ascending. Every ring has the same number of vertices.
std::vector<double> ring_azimuths(const BladeShape& shape, const std::vector<CellSteps>& steps,
                                  const MeridianNode& at) {
  std::vector<double> azimuths;
  for (std::size_t k = 0; k < shape.blades.size(); ++k) {
    const Cell c = cell_at(shape, k, at);
    add_steps(c.front, c.foot, steps[k].front_wall, azimuths);
    add_steps(c.foot, c.next_foot, steps[k].slot, azimuths);
    add_steps(c.next_foot, c.next_edge, steps[k].back_wall, azimuths);
    add_steps(c.next_edge, c.next_front, steps[k].top, azimuths);
  }
  return azimuths;
}

/// Places of the rings, without the axis: at every node, and in steps of at most `edge` in between.
std::vector<double> ring_places(const BladeShape& shape, double edge) {
  std::vector<double> places;
  for (std::size_t i = 1; i < shape.meridian.size(); ++i) {
    const double a = shape.meridian[i - 1].s, b = shape.meridian[i].s;
    const int n = steps_over(b - a, edge);
    for (int k = 1; k <= n; ++k) places.push_back(std::lerp(a, b, static_cast<double>(k) / n));
  }
  return places;
}

/// Connects the last two rings of n vertices.
void stitch_last_rings(int n, mesh::TriangleMesh& m) {
  const int b = static_cast<int>(m.positions.size()) - n, a = b - n;
  for (int j = 0; j < n; ++j) {
    const int next = (j + 1) % n;
    m.triangles.push_back({a + j, b + j, b + next});
    m.triangles.push_back({a + j, b + next, a + next});
  }
}

/// The shank: a neck and a cylinder with the azimuths of the gage's last ring.
void add_shank(const std::vector<double>& azimuths, const BladeOptions& options, double gage_radius,
               double gage_end, mesh::TriangleMesh& m) {
  const int n = static_cast<int>(azimuths.size());
  const double radius = options.shank_radius * gage_radius, shoulder = gage_end - options.neck;
  const double end = shoulder - options.shank_length * gage_radius;
  for (const double z : {shoulder, end}) {
    for (const double a : azimuths)
      m.positions.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
    stitch_last_rings(n, m);
  }
  const int ring = static_cast<int>(m.positions.size()) - n;
  m.positions.emplace_back(0.0, 0.0, end);
  for (int j = 0; j < n; ++j) m.triangles.push_back({ring + j, ring + n, ring + (j + 1) % n});
}

mesh::TriangleMesh blade_mesh(const BladeShape& shape, const BladeOptions& options,
                              double gage_radius) {
  const std::vector<CellSteps> steps = cell_steps(shape, options.edge);
  mesh::TriangleMesh m;
  m.positions.push_back(surface_point_B(shape, shape.meridian.front(), 0.0));
  std::vector<double> azimuths;
  for (const double s : ring_places(shape, options.edge)) {
    const MeridianNode at = meridian_at(shape, s);
    azimuths = ring_azimuths(shape, steps, at);
    for (const double a : azimuths) m.positions.push_back(surface_point_B(shape, at, a));
    const int n = static_cast<int>(azimuths.size());
    if (static_cast<int>(m.positions.size()) > 1 + n)
      stitch_last_rings(n, m);
    else
      for (int j = 0; j < n; ++j) m.triangles.push_back({0, 1 + j, 1 + (j + 1) % n});
  }
  add_shank(azimuths, options, gage_radius, shape.meridian.back().top.z, m);
  return m;
}

}  // namespace

Part blade_body(const std::vector<Cutter>& cutters, const BladeOptions& options,
                double gage_radius) {
  Part body;
  body.name = "bit-body";
  body.kind = PartKind::bit_body;
  body.cutting = options.cutting;
  body.mesh_P = blade_mesh(blade_shape(cutters, options), options, gage_radius);
  body.density = options.density;
  return body;
}

double junk_slot_area(const BladeShape& shape, const BladeOptions& options, double gage_radius) {
  const MeridianNode& gage = shape.meridian.back();
  const std::vector<double> azimuths = ring_azimuths(shape, cell_steps(shape, options.edge), gage);
  double doubled = 0.0;
  for (std::size_t j = 0; j < azimuths.size(); ++j) {
    const Vec3 a = surface_point_B(shape, gage, azimuths[j]);
    const Vec3 b = surface_point_B(shape, gage, azimuths[(j + 1) % azimuths.size()]);
    doubled += a.x() * b.y() - a.y() * b.x();
  }
  return pi * gage_radius * gage_radius - 0.5 * doubled;
}

namespace {

constexpr double least_core = 0.3;  ///< times the gage radius: room for bore and steel

std::string named(const Cutter& c) {
  return fmt::format("cutter {} (blade {}, radius {})", c.id, c.blade, mm_text(c.tip_radius));
}

void check_exposure(const std::vector<Cutter>& cutters, double exposure,
                    std::vector<BladeProblem>& problems) {
  for (const Cutter& c : cutters) {
    const double bare = exposure - c.under_exposure, all = c.diameter * std::cos(c.back_rake);
    if (bare >= all)
      problems.push_back({"exposure",
                          mm_text(exposure) + ", which lifts " + named(c) + " off its blade",
                          "less than " + mm_text(all + c.under_exposure)});
    if (bare <= c.wear)
      problems.push_back(
          {"exposure",
           fmt::format("{}, which leaves nothing of {} outside the blade: wear {}, under-exposure "
                       "{}",
                       mm_text(exposure), named(c), mm_text(c.wear), mm_text(c.under_exposure)),
           "more than " + mm_text(c.wear + c.under_exposure)});
    if (!problems.empty()) return;
  }
}

double cross(const HalfPlanePoint& o, const HalfPlanePoint& a, const HalfPlanePoint& b) {
  return (a.r - o.r) * (b.z - o.z) - (a.z - o.z) * (b.r - o.r);
}

/// Whether the lines from top to floor do not cross between two nodes.
bool stays_apart(const MeridianNode& a, const MeridianNode& b) {
  return cross(a.top, b.top, b.floor) < 0.0 && cross(a.top, b.floor, a.floor) < 0.0 &&
         cross(a.top, b.top, a.floor) < 0.0 && cross(b.top, b.floor, a.floor) < 0.0;
}

/// The first place at which the floor of the slots folds, or null.
const MeridianNode* fold(const BladeShape& shape) {
  for (std::size_t k = 1; k < shape.meridian.size(); ++k)
    if (!stays_apart(shape.meridian[k - 1], shape.meridian[k])) return &shape.meridian[k];
  return nullptr;
}

bool has_core(const BladeShape& shape, double gage_radius) {
  return shape.meridian.back().floor.r >= least_core * gage_radius;
}

double deepest_slot(const std::vector<Cutter>& cutters, BladeOptions options, double gage_radius) {
  double fine = 0.0, bad = options.slot_depth;
  constexpr int halvings = 30;
  for (int k = 0; k < halvings; ++k) {
    options.slot_depth = 0.5 * (fine + bad);
    const BladeShape shape = blade_shape(cutters, options);
    (fold(shape) || !has_core(shape, gage_radius) ? bad : fine) = options.slot_depth;
  }
  return fine;
}

void check_slots(const std::vector<Cutter>& cutters, const BladeShape& shape,
                 const BladeOptions& options, double gage_radius,
                 std::vector<BladeProblem>& problems) {
  const MeridianNode* place = fold(shape);
  if (!place && has_core(shape, gage_radius)) return;
  const std::string what =
      place ? fmt::format("a floor that folds at radius {}, height {}", mm_text(place->top.r),
                          mm_text(-place->top.z))
            : fmt::format("slots that leave no core: a floor at radius {} on the gage",
                          mm_text(shape.meridian.back().floor.r));
  const double most = deepest_slot(cutters, options, gage_radius);
  problems.push_back({"slot_depth", mm_text(options.slot_depth) + ", " + what,
                      "at most " + mm_text(std::floor(1e5 * most) / 1e5)});
}

void check_width(const std::vector<Cutter>& cutters, const BladeShape& shape,
                 std::vector<BladeProblem>& problems) {
  for (const Cutter& c : cutters)
    for (const BladeStrip& blade : shape.blades) {
      const double s = place_of(shape, c);
      const double needed = trail_of(blade, c, s) - 0.5 * c.length;
      if (blade.blade != c.blade || needed <= blade.width) continue;
      problems.push_back({"width", mm_text(blade.width) + ", a blade that ends before " + named(c),
                          "at least " + mm_text(needed)});
      return;
    }
}

void check_neighbours(const BladeShape& shape, std::vector<BladeProblem>& problems) {
  const std::size_t n = shape.blades.size();
  for (std::size_t k = 0; k < n; ++k) {
    const BladeStrip &a = shape.blades[k], &b = shape.blades[(k + 1) % n];
    for (const MeridianNode& at : shape.meridian) {
      const double gap = front_at(b, at.s) + (k + 1 == n ? full_turn : 0.0) - front_at(a, at.s);
      const bool at_gage = &at == &shape.meridian.back();
      const double taken = at_gage ? b.width + 2.0 * shape.wall : 0.0;
      if (gap * at.top.r > taken || (at.top.r == 0.0 && gap > 0.0)) continue;
      problems.push_back(
          {"width",
           fmt::format("blades {} and {} that {} at radius {}: {} from front to front", a.blade,
                       b.blade, at_gage ? "close the slot between them" : "cross",
                       mm_text(at.top.r), mm_text(gap * at.top.r)),
           at_gage ? fmt::format("more than the width {} and two walls of {}", mm_text(b.width),
                                 mm_text(shape.wall))
                   : "blades one behind the other"});
      break;
    }
  }
}

}  // namespace

std::vector<BladeProblem> blade_problems(const std::vector<Cutter>& cutters,
                                         const BladeOptions& options, double gage_radius) {
  std::vector<BladeProblem> problems;
  check_exposure(cutters, options.exposure, problems);
  if (!problems.empty()) return problems;
  const BladeShape shape = blade_shape(cutters, options);
  check_slots(cutters, shape, options, gage_radius, problems);
  check_width(cutters, shape, problems);
  check_neighbours(shape, problems);
  return problems;
}

}  // namespace tdbd::bit
