#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/body/blade_body.hpp"
#include "bit/text.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
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
