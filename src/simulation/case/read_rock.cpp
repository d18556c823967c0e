#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bit/areas/area_rules.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/files/file_checks.hpp"
#include "core/types.hpp"
#include "simulation/case/rock_settings.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::simulation {
namespace {

/// The mesh does not resolve waves shorter than a few edges.
void check_roughness(Config& c, const RockStart& r) {
  constexpr double least_edges = 2.0;
  if (r.roughness.correlation_length < least_edges * r.edge_length)
    c.problem("correlation_length", fmt::format("{} m", r.roughness.correlation_length),
              fmt::format("at least two edges, {} m", least_edges * r.edge_length));
}

void check_profile(Config& c, const std::vector<rock::MeridianPoint>& p) {
  const auto wrong = [&](const std::string& found) {
    c.problem("profile", found,
              "two points or more, [radius, depth], the first on the axis, the others beside it");
  };
  if (p.size() < 2) return wrong(fmt::format("{} points", p.size()));
  if (p.front().r != 0.0) return wrong(fmt::format("a first point of radius {} m", p.front().r));
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!(std::max(p[i].r, std::abs(p[i].z)) <= largest_length))
      return c.problem("profile", fmt::format("point {} at [{}, {}] m", i + 1, p[i].r, p[i].z),
                       fmt::format("points within {:.0e} m", largest_length));
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (!(p[i].r > 0.0)) return wrong(fmt::format("radius {} m of point {}", p[i].r, i + 1));
    if (p[i].r == p[i - 1].r && p[i].z == p[i - 1].z)
      return wrong(fmt::format("point {} twice", i));
  }
}

Surroundings read_surroundings(Config& c) {
  Surroundings s;
  read_fields(c, s);
  return s;
}

}  // namespace

std::vector<std::string_view> NamedRock::names() {
  std::vector<std::string_view> all;
  for (const forces::KnownRock& rock : forces::known_rocks()) all.push_back(rock.name);
  return all;
}

forces::RockMaterial read_material(Config& c) {
  if (c.has("material.unconfined_strength")) return read_table<RockByNumbers>(c).material;
  NamedRock rock;
  read_fields(c, rock);
  return forces::rock_named(rock.material);
}

RockStart read_rock(Config& whole) {
  const RockStart r = read_table<RockStart>(whole);
  Config c = whole.table(RockStart::table);
  if (r.shape == RockShape::rough) check_roughness(c, r);
  if (r.shape == RockShape::profile) check_profile(c, r.profile);
  if (r.shape == RockShape::file) bit::contradicts_unit(c, r.file, r.unit);
  return r;
}

std::vector<Bed> read_beds(Config c, BedMaterial material) {
  const Surroundings s = read_surroundings(c);
  const auto bed = [&](Config& of) {
    Bed b;
    if (material == BedMaterial::read) b.material = read_material(of);
    b.confining_pressure = forces::confining_pressure(s.hole, s.confinement, b.material.porosity);
    return b;
  };
  std::vector<Bed> beds{bed(c)};
  if (material == BedMaterial::read)
    for (Config& layer : c.tables(RockLayer::table)) beds.push_back(bed(layer));
  return beds;
}

forces::Formation read_formation(Config c) {
  forces::Formation f;
  const Surroundings s = read_surroundings(c);
  const auto strength = [&](Config& of) {
    return forces::strength_of(read_material(of), s.hole, s.confinement);
  };
  Bedding bedding;
  read_fields(c, bedding);
  f.normal_W = forces::bedding_normal(bedding.dip, bedding.azimuth);
  f.strengths.push_back(strength(c));
  for (Config& layer : c.tables(RockLayer::table)) {
    RockLayer bed;
    read_fields(layer, bed);
    f.tops.push_back(bed.top);
    f.strengths.push_back(strength(layer));
    if (f.tops.size() > 1 && !(f.tops.back() > f.tops[f.tops.size() - 2]))
      layer.problem("top", fmt::format("{} m", f.tops.back()),
                    "a top below that of the layer above");
  }
  return f;
}

namespace {

bool is_face(const bit::Part& part) { return part.kind == bit::PartKind::face && part.cutter >= 0; }

void check_angle(Config& c, double angle) {
  if (c.has("angle") && !(angle > 0.0 && angle < right_angle))
    c.problem("angle", fmt::format("{:g} degrees", angle / degree), "an angle in (0, 90) degrees");
}

void require_faces(Config& c, const bit::Bit& bit, const std::vector<int>& parts) {
  for (const int p : parts)
    if (const bit::Part& part = bit.parts[at(p)]; !is_face(part))
      return c.problem("", fmt::format("{}, which is not the face of a cutter", part.name),
                       "criteria that select faces, because rock breaks out only beside them");
}

/// The properties that each area defines.
std::vector<BreakoutArea> read_area_rules(bit::Areas& areas, const bit::Bit& bit) {
  std::vector<BreakoutArea> given(areas.tables.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    Config& c = areas.tables[i].config;
    BreakoutArea& g = given[i];
    require_faces(c, bit, bit::parts_of_rule(areas, static_cast<int>(i)));
    read_fields(c, g);
    if (g.angle) check_angle(c, *g.angle);
    if (!g.angle && !g.depth_share && !g.ahead_share)
      c.problem("", "no property", "angle, depth_share or ahead_share");
  }
  return given;
}

/// A property of breakout rules that areas may change.
struct RuleProperty {
  const char* key;
  std::optional<double> BreakoutArea::*given;
  double rock::BreakoutRule::*value;
  const char* unit;
  double in_unit;
};

/// `rules`: per part.
void read_spalling_areas(Config& c, const bit::Bit& bit, const std::string& where,
                         std::vector<rock::BreakoutRule>& rules) {
  using Area = BreakoutArea;
  using Rule = rock::BreakoutRule;
  if (!c.has("areas")) return;
  bit::Areas areas = bit::read_areas(c.table("areas"), bit, where);
  const std::vector<Area> given = read_area_rules(areas, bit);
  for (const RuleProperty& p :
       {RuleProperty{"angle", &Area::angle, &Rule::angle, " degrees", degree},
        RuleProperty{"depth_share", &Area::depth_share, &Rule::depth_share, "", 1.0},
        RuleProperty{"ahead_share", &Area::ahead_share, &Rule::ahead_share, "", 1.0}}) {
    std::vector<std::optional<double>> values;
    std::vector<std::string> shown;
    for (const Area& g : given) {
      values.push_back(g.*p.given);
      shown.push_back(fmt::format("{:g}{}", values.back().value_or(0.0) / p.in_unit, p.unit));
    }
    const std::vector<int> area = bit::decide_or_report(areas, bit, p.key, values, shown);
    for (std::size_t i = 0; i < bit.parts.size(); ++i)
      if (area[i] >= 0) rules[i].*p.value = *values[at(area[i])];
  }
}

/// Rock moves along the update direction until it is below the crack. The direction must therefore
/// lead out of the rock on both sides.
void require_way_out(Config& c, const bit::Bit& bit, const bit::Part& face, double angle) {
  constexpr double least = 0.05;  // sine of the angle between crack and direction
  const bit::Cutter& cutter = bit.cutters[at(face.cutter)];
  const Vec3 normal_B = bit::profile_normal_B(cutter),
             across_B = bit::direction_of_motion_B(cutter).cross(normal_B);
  const Vec3 u_B = Eigen::AngleAxisd(cutter.azimuth, Vec3::UnitZ()) * face.update_direction_B;
  const double leans = std::atan2(std::abs(u_B.dot(across_B)), u_B.dot(normal_B));
  if (std::sin(angle - leans) < least)
    c.problem("angle",
              fmt::format("{:g} degrees for {}, which moves rock at {:.1f} degrees from the "
                          "profile's normal",
                          angle / degree, face.name, leans / degree),
              fmt::format("more than {:.1f} degrees for it", (leans + std::asin(least)) / degree));
}

/// Whether rock of each bed breaks out.
std::vector<std::uint8_t> breaking_beds(Config& c, Config& whole, double most,
                                        const ForcePlan& forces) {
  BreakingMaterial breaking;
  read_fields(c, breaking);
  const bool any = !breaking.material;
  const std::string material = breaking.material.value_or("");
  const bool is_known = forces.forces == Forces::on || !any;
  const std::vector<Bed> beds =
      read_beds(whole.table(RockStart::table), is_known ? BedMaterial::read : BedMaterial::unknown);
  std::vector<std::uint8_t> breaks;
  std::string names;
  bool is_there = any;
  for (const Bed& bed : beds) {
    const bool is_it = any || bed.material.name == material;
    is_there = is_there || is_it;
    breaks.push_back(is_it && bed.confining_pressure <= most);
    names += (names.empty() ? "" : ", ") + bed.material.name;
  }
  if (!is_there)
    c.problem("material", fmt::format("\"{}\"", material),
              fmt::format("a rock of [rock]: {}", names));
  return breaks;
}

void require_spalling_bit(Config& c, const bit::Bit& bit, const MeasurePlan& measure) {
  if (bit.parts.empty()) return;  // its mistakes are already recorded
  if (std::ranges::none_of(bit.parts, is_face))
    c.problem("", "a bit without faces of cutters", "a bit with cutters");
  if (measure.section == SectionMeasure::off)
    c.problem("", "measure.section = \"off\"",
              "sections: cracks start at the ends of the engaged edge");
}

}  // namespace

BreakoutSettings read_breakout_rule(Config& c) {
  BreakoutSettings s;
  read_fields(c, s);
  check_angle(c, s.rule.angle);
  return s;
}

SpallingPlan read_spalling(Config& whole, const bit::Bit& bit, const MeasurePlan& measure,
                           const ForcePlan& forces, std::vector<CaseWarning>& warnings) {
  SpallingPlan plan;
  if (!whole.has(BreakoutSettings::table)) return plan;
  Config c = whole.table(BreakoutSettings::table);
  const BreakoutSettings settings = read_breakout_rule(c);
  std::vector<rock::BreakoutRule> rules(bit.parts.size(), settings.rule);
  const std::string where = fmt::format("{} of {}", bit.name, read_table<BitSettings>(whole).file);
  read_spalling_areas(c, bit, where, rules);
  require_spalling_bit(c, bit, measure);
  plan.beds = breaking_beds(c, whole, settings.up_to_pressure, forces);
  if (whole.problem_count() > 0) return {};
  plan.rules.resize(bit.cutters.size());
  for (std::size_t p = 0; p < bit.parts.size(); ++p) {
    if (!is_face(bit.parts[p]) || !breaks_out(rules[p])) continue;
    if (rules[p].depth_share > 0.0) require_way_out(c, bit, bit.parts[p], rules[p].angle);
    plan.rules[at(bit.parts[p].cutter)] = rules[p];
  }
  if (std::ranges::any_of(plan.beds, [](std::uint8_t breaks) { return breaks != 0; })) return plan;
  warnings.push_back({whole.place(BreakoutSettings::table.name),
                      std::string(BreakoutSettings::table.name),
                      "no rock breaks out: all of it is confined by more than up_to_pressure"});
  return {};
}

}  // namespace tdbd::simulation
