#include "bit/files/adjust_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "bit/cutter/cutter.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

/// Increments of a cutter's values.
struct Adjustment {
  double azimuth = 0.0, back_rake = 0.0, side_rake = 0.0;  ///< rad
  double along = 0.0;                                      ///< m
};

Adjustment read_adjustment(Config& c) {
  using namespace adjust_keys;
  return {c.read(azimuth), c.read(back_rake), c.read(side_rake), c.read(along)};
}

void add(const Adjustment& a, Cutter& c) {
  c.azimuth += a.azimuth;
  c.back_rake += a.back_rake;
  c.side_rake += a.side_rake;
  c.tip_radius += a.along * std::cos(c.profile_angle);
  c.tip_height += a.along * std::sin(c.profile_angle);
}

/// Adjusts the cutters whose number is the name of a table: [adjust.blade.2].
void adjust_some(Config c, int Cutter::*number, const char* what, std::vector<Cutter>& cutters) {
  for (const std::string& name : c.given()) {
    Config table = c.table(name);
    const Adjustment a = read_adjustment(table);
    int wanted = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), wanted);
    long found = 0;
    for (Cutter& cutter : cutters)
      if (error == std::errc() && end == name.data() + name.size() && cutter.*number == wanted) {
        add(a, cutter);
        ++found;
      }
    const std::vector<std::string> given = table.given();
    if (found == 0 && !cutters.empty())
      table.problem(given.empty() ? "" : given.front(), "a table of " + name,
                    fmt::format("the number of a {}", what));
  }
}

/// Records values that a cutter table would not allow either.
void check_adjusted(Config& c, const Cutter& cutter) {
  const auto refuse = [&](const char* key, double found, const char* unit, const char* expected) {
    c.problem(key, fmt::format("{:.4g} {} of cutter {} in the end", found, unit, cutter.id),
              expected);
  };
  const double back = cutter.back_rake / degree, side = cutter.side_rake / degree;
  if (back < -5.0 || back > 60.0) refuse("back_rake", back, "deg", "an angle in -5..60");
  if (std::abs(side) > 45.0) refuse("side_rake", side, "deg", "an angle in -45..45");
  if (cutter.tip_radius < 0.0)
    refuse("along", 1e3 * cutter.tip_radius, "mm from the axis", "a radius >= 0");
}

}  // namespace

void adjust_cutters(Config adjust, std::vector<Cutter>& cutters) {
  if (adjust.given().empty()) return;
  const Adjustment all = read_adjustment(adjust);
  for (Cutter& c : cutters) add(all, c);
  adjust_some(adjust.table(adjust_keys::blade), &Cutter::blade, "blade", cutters);
  adjust_some(adjust.table(adjust_keys::cutter), &Cutter::id, "cutter", cutters);
  for (Cutter& c : cutters) {
    check_adjusted(adjust, c);
    c.X_BC = cutter_pose(c);
  }
}

}  // namespace tdbd::bit
