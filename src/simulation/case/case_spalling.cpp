#include "simulation/case/case_spalling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "bit/areas/read_areas.hpp"
#include "bit/cutter/cutter.hpp"
#include "core/types.hpp"
#include "simulation/case/case_rock.hpp"
#include "simulation/case/rock_keys.hpp"
#include "simulation/case/run_keys.hpp"
#include "simulation/case/spalling_keys.hpp"

namespace tdbd::simulation {
namespace {

bool is_face(const bit::Part& part) { return part.kind == bit::PartKind::face && part.cutter >= 0; }

double read_angle(Config& c) {
  const double angle = c.read(spalling_keys::angle);
  if (c.has(spalling_keys::angle) && !(angle > 0.0 && angle < right_angle))
    c.problem(spalling_keys::angle, fmt::format("{:g} degrees", angle / degree),
              "an angle in (0, 90) degrees");
  return angle;
}

/// A property of areas, where they give it.
struct Given {
  std::vector<std::optional<double>> values;
  std::vector<std::string> shown;
};

void require_faces(Config& c, const bit::Bit& bit, const std::vector<int>& parts) {
  for (const int p : parts)
    if (const bit::Part& part = bit.parts[at(p)]; !is_face(part))
      return c.problem("", fmt::format("{}, which is no face of a cutter", part.name),
                       "criteria that select faces: rock breaks out beside them alone");
}

Given read_angles(bit::Areas& areas) {
  Given given;
  for (bit::AreaTable& area : areas.tables) {
    given.values.emplace_back();
    if (area.config.has(spalling_keys::angle)) given.values.back() = read_angle(area.config);
    given.shown.push_back(fmt::format("{:g} degrees", given.values.back().value_or(0.0) / degree));
  }
  return given;
}

Given read_shares(bit::Areas& areas, const QuantityKey& key) {
  Given given;
  for (bit::AreaTable& area : areas.tables) {
    given.values.emplace_back();
    if (area.config.has(key)) given.values.back() = area.config.read(key);
    given.shown.push_back(fmt::format("{:g}", given.values.back().value_or(0.0)));
  }
  return given;
}

void require_property(bit::Areas& areas, const std::array<Given, 3>& given) {
  for (std::size_t i = 0; i < areas.tables.size(); ++i)
    if (std::ranges::none_of(given, [&](const Given& g) { return g.values[i].has_value(); }))
      areas.tables[i].config.problem("", "no property", "angle, depth_share or ahead_share");
}

/// `rules`: per part.
void read_spalling_areas(Config& c, const bit::Bit& bit, const std::string& where,
                         std::vector<rock::BreakoutRule>& rules) {
  if (!c.has(spalling_keys::areas.name)) return;
  bit::Areas areas = bit::read_areas(c.table(spalling_keys::areas), bit, where);
  for (std::size_t i = 0; i < areas.tables.size(); ++i)
    require_faces(areas.tables[i].config, bit, bit::parts_of_rule(areas, static_cast<int>(i)));
  const std::array keys{spalling_keys::angle, spalling_keys::depth_share,
                        spalling_keys::ahead_share};
  const std::array given{read_angles(areas), read_shares(areas, keys[1]),
                         read_shares(areas, keys[2])};
  require_property(areas, given);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::vector<int> area =
        bit::decide_or_report(areas, bit, keys[k].name, given[k].values, given[k].shown);
    for (std::size_t p = 0; p < bit.parts.size(); ++p) {
      rock::BreakoutRule& r = rules[p];
      double& value = k == 0 ? r.angle : k == 1 ? r.depth_share : r.ahead_share;
      if (area[p] >= 0) value = *given[k].values[at(area[p])];
    }
  }
}

/// Rock moves along the update direction until it is below the crack, so that it must lead out of the
/// rock on both sides.
void require_way_out(Config& c, const bit::Bit& bit, const bit::Part& face, double angle) {
  constexpr double least = 0.05;  // sine of the angle between crack and direction
  const bit::Cutter& cutter = bit.cutters[at(face.cutter)];
  const Vec3 normal_B = bit::profile_normal_B(cutter),
             across_B = bit::direction_of_motion_B(cutter).cross(normal_B);
  const Vec3 u_B = Eigen::AngleAxisd(cutter.azimuth, Vec3::UnitZ()) * face.update_direction_B;
  const double leans = std::atan2(std::abs(u_B.dot(across_B)), u_B.dot(normal_B));
  if (std::sin(angle - leans) < least)
    c.problem(spalling_keys::angle,
              fmt::format("{:g} degrees for {}, which moves rock at {:.1f} degrees from the "
                          "profile's normal",
                          angle / degree, face.name, leans / degree),
              fmt::format("more than {:.1f} degrees for it", (leans + std::asin(least)) / degree));
}

/// Whether rock of each bed breaks out.
std::vector<std::uint8_t> breaking_beds(Config& c, Config& whole, const ForcePlan& forces) {
  const double most = c.read(spalling_keys::up_to_pressure);
  const bool any = !c.has(spalling_keys::material);
  const std::string material = any ? "" : c.read(spalling_keys::material);
  const bool is_known = forces.forces == Forces::on || !any;
  const std::vector<Bed> beds =
      read_beds(whole.table(rock_keys::table), is_known ? BedMaterial::read : BedMaterial::unknown);
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
    c.problem(spalling_keys::material, fmt::format("\"{}\"", material),
              fmt::format("a rock of [rock]: {}", names));
  return breaks;
}

void require_spalling_bit(Config& c, const bit::Bit& bit, const MeasurePlan& measure) {
  if (bit.parts.empty()) return;  // its own mistakes are noted
  if (std::ranges::none_of(bit.parts, is_face))
    c.problem("", "a bit without faces of cutters", "a bit with cutters");
  if (measure.section == SectionMeasure::off)
    c.problem("", "measure.section = \"off\"",
              "sections: cracks start at the ends of the engaged edge");
}

}  // namespace

rock::BreakoutRule read_breakout_rule(Config& c) {
  return {read_angle(c), c.read(spalling_keys::depth_share), c.read(spalling_keys::ahead_share)};
}

SpallingPlan read_spalling(Config& whole, const bit::Bit& bit, const MeasurePlan& measure,
                           const ForcePlan& forces, std::vector<CaseWarning>& warnings) {
  SpallingPlan plan;
  if (!whole.has(spalling_keys::table)) return plan;
  Config c = whole.table(spalling_keys::table);
  std::vector<rock::BreakoutRule> rules(bit.parts.size(), read_breakout_rule(c));
  const std::string where =
      fmt::format("{} of {}", bit.name, whole.table(bit_keys::table).read(bit_keys::file));
  read_spalling_areas(c, bit, where, rules);
  require_spalling_bit(c, bit, measure);
  plan.beds = breaking_beds(c, whole, forces);
  if (whole.problem_count() > 0) return {};
  plan.rules.resize(bit.cutters.size());
  for (std::size_t p = 0; p < bit.parts.size(); ++p) {
    if (!is_face(bit.parts[p]) || !breaks_out(rules[p])) continue;
    if (rules[p].depth_share > 0.0) require_way_out(c, bit, bit.parts[p], rules[p].angle);
    plan.rules[at(bit.parts[p].cutter)] = rules[p];
  }
  if (std::ranges::any_of(plan.beds, [](std::uint8_t breaks) { return breaks != 0; })) return plan;
  warnings.push_back({whole.place(spalling_keys::table.name),
                      std::string(spalling_keys::table.name),
                      "no rock breaks out: all of it is confined by more than up_to_pressure"});
  return {};
}

}  // namespace tdbd::simulation
