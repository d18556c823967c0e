#pragma once

#include <vector>

#include "bit/areas/area_rules.hpp"
#include "bit/wear/wear_law.hpp"
#include "core/config/config.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::simulation {

/// The kind of a wear law.
enum class WearKind { none, sliding, thermal, table };

/// The wear law that a table names, with its coefficients.
struct WearLawSettings {
  WearKind law = WearKind::none;
  bit::SlidingWear sliding;
  double threshold = 0.0, growth = 50.0;
  bit::TableWear rates;

  void visit(FieldVisitor& v) {
    v(law, {.name = "law",
            .values = {{{"sliding", WearKind::sliding},
                        {"thermal", WearKind::thermal},
                        {"table", WearKind::table},
                        {"none", WearKind::none}}},
            .need = Need::required,
            .meaning = "worn volume per path and normal force. sliding: coefficient/hardness "
                       "(Archard); thermal: times exp((T - threshold)/growth) above the threshold "
                       "(Glowka); table: rates"});
    if (v.when(law == WearKind::sliding || law == WearKind::thermal)) {
      v(sliding.coefficient, {.name = "coefficient",
                              .need = Need::required,
                              .usual = "required by sliding and thermal",
                              .range = Range::non_negative(),
                              .meaning = "of Archard's law"});
      v(sliding.hardness, {.name = "hardness",
                           .unit = "Pa",
                           .need = Need::required,
                           .usual = "required by sliding and thermal",
                           .range = Range::positive(),
                           .meaning = "of the worn material"});
    }
    if (v.when(law == WearKind::thermal)) {
      v(threshold, {.name = "threshold",
                    .unit = "K",
                    .need = Need::required,
                    .usual = "required by thermal",
                    .range = Range::positive(),
                    .meaning = "temperature limit: a hotter flat wears faster"});
      v(growth, {.name = "growth",
                 .unit = "K",
                 .range = Range::positive(),
                 .meaning = "thermal: rise of temperature that multiplies the rate by e"});
    }
    if (v.when(law == WearKind::table)) {
      v(rates.temperatures, {.name = "temperatures",
                             .unit = "K",
                             .need = Need::required,
                             .usual = "required by table",
                             .meaning = "rising"});
      v(rates.rates, {.name = "rates",
                      .unit = "m3 N-1 m-1",
                      .need = Need::required,
                      .usual = "required by table",
                      .meaning = "worn volume per path and normal force, one for each temperature; "
                                 "linear between them"});
    }
  }
};

/// [wear]: how the bit wears.
struct WearPlan {
  std::vector<bit::WearLaw> part_laws;  ///< by part; empty: no wear
  bit::FlatHeating heating;
  double acceleration = 1.0;
  double from = 0.0;
  long every_steps = 0;
  double every = 0.0;
  double largest_growth = 0.005;

  static constexpr TableKey table{
      "wear",
      "wear of cutters from a cutter table, of the teeth of cones and, by area, of gage pads"};
  void visit(FieldVisitor& v) {
    v(acceleration,
      {.name = "acceleration",
       .range = Range::positive(),
       .meaning =
           "multiplies the rates: one metre drilled wears the bit like this number of metres"});
    v(from, {.name = "from",
             .unit = "s",
             .range = Range::non_negative(),
             .meaning =
                 "the bit does not wear before this time: the first revolutions of a run, in which "
                 "drilling is not yet steady, would count for as many metres as all others"});
    v(every_steps, {.name = "every_steps",
                    .meaning = "largest number of time steps between two wear steps; 0: no limit"});
    v(every,
      {.name = "every",
       .unit = "m",
       .range = Range::non_negative(),
       .meaning = "largest distance that the bit goes down between two wear steps; 0: no limit"});
    v(largest_growth,
      {.name = "largest_growth",
       .range = Range::within(1e-6, 0.1),
       .meaning = "largest growth of a flat's height in a wear step, over the diameter of its "
                  "cutter, the protrusion of its tooth, or the thickness of its pad; wear steps "
                  "are as frequent as this requires"});
    v(heating.friction, {.name = "friction",
                         .range = Range::non_negative(),
                         .meaning = "of the flat on the rock, for its heating; assumed"});
    v(heating.rock_conductivity, {.name = "rock_conductivity",
                                  .unit = "W/(m K)",
                                  .range = Range::positive(),
                                  .meaning = "thermal; assumed"});
    v(heating.rock_diffusivity, {.name = "rock_diffusivity",
                                 .unit = "m2/s",
                                 .range = Range::positive(),
                                 .meaning = "thermal; assumed"});
    v(heating.cutter_resistance,
      {.name = "cutter_resistance",
       .unit = "K m2/W",
       .range = Range::non_negative(),
       .meaning = "thermal, from a flat to the drilling fluid; assumed"});
    v(heating.fluid_temperature, {.name = "fluid_temperature",
                                  .unit = "K",
                                  .range = Range::positive(),
                                  .meaning = "of the drilling fluid"});
  }
};

/// [wear.areas.NAME]: another wear law for the parts of an area.
struct WearArea : WearLawSettings {
  static constexpr TableKey table{
      "wear.areas.NAME",
      "another wear law for the parts that meet all criteria given here; of several areas the one "
      "with the most specific criterion decides"};
};

/// Whether the bit wears.
inline bool wears(const WearPlan& plan) { return !plan.part_laws.empty(); }

/// Reads [wear] and [wear.areas.NAME]. Without the table, the bit does not wear. The law of [wear]
/// applies to all parts of cutters and to teeth, that of an area to its parts (bit::decide); gage
/// pads wear only in areas. Records as mistakes: those of bit::read_areas, two areas of equal rank
/// with different laws, an area with parts other than those of cutters, teeth and gage pads, an
/// area without any that wear, a case without [forces], and tables of rates that do not match their
/// temperatures.
WearPlan read_wear(Config& whole, const bit::Bit& bit, const ForcePlan& forces);

}  // namespace tdbd::simulation
