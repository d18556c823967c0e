#include "bit/files/blade_file.hpp"

#include <algorithm>

#include "bit/body/blade_body.hpp"

namespace tdbd::bit {
namespace {

Cutting read_say(Config& c) {
  const bool rubs = c.flag("rubs", true), cuts = c.flag("cuts", false);
  if (cuts) return Cutting::cuts;
  return rubs ? Cutting::rubs : Cutting::never;
}

}  // namespace

std::optional<BladeOptions> read_blades(Config& file) {
  if (!file.has("blades")) return {};
  Config c = file.table("blades");
  BladeOptions b;
  b.exposure = c.quantity("exposure", "m", std::nullopt, Range::positive());
  b.slot_depth = c.quantity("slot_depth", "m", std::nullopt, Range::positive());
  b.width = c.quantity("width", "m", b.width, Range::non_negative());
  b.wall = c.quantity("wall", "m", b.wall, Range::positive());
  b.gage_length = c.quantity("gage_length", "m", b.gage_length, Range::positive());
  b.neck = c.quantity("neck", "m", b.neck, Range::positive());
  b.shank_radius = c.quantity("shank_radius", "1", b.shank_radius, Range::within(0.1, 0.9));
  b.shank_length = c.quantity("shank_length", "1", b.shank_length, Range::within(0.1, 10.0));
  b.edge = c.quantity("edge", "m", b.edge, Range::within(2e-4, 0.05));
  b.density = c.quantity("density", "kg/m3", b.density, Range::non_negative());
  b.cutting = read_say(c);
  return b;
}

void check_blades(Config& file, const std::vector<Cutter>& cutters, const BladeOptions& blades) {
  if (cutters.empty() || file.problem_count() > 0) return;
  Config c = file.table("blades");
  const double gage = std::ranges::max(cutters, {}, &Cutter::tip_radius).tip_radius;
  for (const BladeProblem& p : blade_problems(cutters, blades, gage))
    c.problem(p.key, p.found, p.expected);
}

}  // namespace tdbd::bit
