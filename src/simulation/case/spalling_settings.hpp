#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "rock/section/breakout.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::simulation {

/// [spalling]: rock that breaks out around the faces of cutters.
struct BreakoutSettings {
  rock::BreakoutRule rule;
  double up_to_pressure = 1e6;

  static constexpr TableKey table{
      "spalling", "rock that breaks out around the faces of cutters (off without it)"};
  void visit(FieldVisitor& v) {
    visit_rule(v, rule.angle, rule.depth_share, rule.ahead_share, Need::required);
    v(up_to_pressure, {.name = "up_to_pressure",
                       .unit = "Pa",
                       .range = Range::non_negative(),
                       .meaning = "confining pressure above which no rock breaks out; assumed"});
  }

  /// `Value`: double, or std::optional<double> if an area may omit it.
  template <class Value>
  static void visit_rule(FieldVisitor& v, Value& angle, Value& depth_share, Value& ahead_share,
                         Need angle_need) {
    v(angle, {.name = "angle",
              .unit = "rad",
              .need = angle_need,
              .meaning = "between a crack and the normal of the bit's profile, in (0, 90) degrees: "
                         "0 is the wall of a groove, 90 degrees the free surface"});
    v(depth_share, {.name = "depth_share",
                    .range = Range::within(0.0, 1.0),
                    .meaning = "share of the engaged depth, from the free surface down, in which "
                               "cracks start; 0: no rock breaks out beside the face"});
    v(ahead_share, {.name = "ahead_share",
                    .range = Range::within(0.0, 0.95),
                    .meaning = "share of the engaged depth, from the free surface down, that chips "
                               "off ahead of a face, which then cuts what is left"});
  }
};

/// The rock that breaks out, in [spalling].
struct BreakingMaterial {
  std::optional<std::string> material;

  void visit(FieldVisitor& v) {
    v(material, {.name = "material",
                 .usual = "any",
                 .meaning = "the rock that breaks out, by its name in [rock]"});
  }
};

/// [spalling.areas.NAME]: another rule for the faces of an area.
struct BreakoutArea {
  std::optional<double> angle, depth_share, ahead_share;

  static constexpr TableKey table{
      "spalling.areas.NAME",
      "another angle or other shares for the faces that meet all criteria given here; of several "
      "areas the one with the most specific criterion decides each of them"};
  void visit(FieldVisitor& v) {
    BreakoutSettings::visit_rule(v, angle, depth_share, ahead_share, Need::optional);
  }
};

/// Rock that breaks out beside faces.
struct SpallingPlan {
  std::vector<std::optional<rock::BreakoutRule>> rules;  ///< per cutter; empty: no rock breaks out
  std::vector<std::uint8_t> beds;  ///< per bed of the formation: whether its rock breaks out
};

/// Whether rock breaks out beside any face.
inline bool spalls(const SpallingPlan& plan) { return !plan.rules.empty(); }

/// Whether any rock breaks out.
inline bool breaks_out(const rock::BreakoutRule& rule) {
  return rule.depth_share > 0.0 || rule.ahead_share > 0.0;
}

/// Reads the rule and the pressure of [spalling]. Records an angle outside (0, 90) degrees as a
/// mistake.
BreakoutSettings read_breakout_rule(Config& c);

/// Reads [spalling] and [spalling.areas.NAME]. Without the table, no rock breaks out. If every bed
/// is confined by more than up_to_pressure, no rock breaks out, either; this is a warning. Records
/// as mistakes: those of bit::read_areas, two areas of equal rank that disagree, an area with a
/// part that is not the face of a cutter, an area without a property, an angle outside (0, 90)
/// degrees or one that the update direction of a face cannot follow, a material that is not in
/// [rock], a bit without faces of cutters, and sections that are off.
SpallingPlan read_spalling(Config& whole, const bit::Bit& bit, const MeasurePlan& measure,
                           const ForcePlan& forces, std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation
