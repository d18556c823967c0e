#include "bit/files/blade_file.hpp"

#include <algorithm>

#include "bit/body/blade_body.hpp"
#include "bit/files/pdc_keys.hpp"

namespace tdbd::bit {
namespace {

Cutting read_say(Config& c) {
  const bool rubs = c.read(blade_keys::rubs), cuts = c.read(blade_keys::cuts);
  if (cuts) return Cutting::cuts;
  return rubs ? Cutting::rubs : Cutting::never;
}

}  // namespace

std::optional<BladeOptions> read_blades(Config& file) {
  if (!file.has(blade_keys::table)) return {};
  Config c = file.table(blade_keys::table);
  BladeOptions b;
  b.exposure = c.read(blade_keys::exposure);
  b.slot_depth = c.read(blade_keys::slot_depth);
  b.width = c.read(blade_keys::width);
  b.wall = c.read(blade_keys::wall);
  b.gage_length = c.read(blade_keys::gage_length);
  b.neck = c.read(blade_keys::neck);
  b.shank_radius = c.read(blade_keys::shank_radius);
  b.shank_length = c.read(blade_keys::shank_length);
  b.edge = c.read(blade_keys::edge);
  b.density = c.read(blade_keys::density);
  b.cutting = read_say(c);
  return b;
}

void check_blades(Config& file, const std::vector<Cutter>& cutters, const BladeOptions& blades) {
  if (cutters.empty() || file.problem_count() > 0) return;
  Config c = file.table(blade_keys::table);
  const double gage = std::ranges::max(cutters, {}, &Cutter::tip_radius).tip_radius;
  for (const BladeProblem& p : blade_problems(cutters, blades, gage))
    c.problem(p.key, p.found, p.expected);
}

}  // namespace tdbd::bit
