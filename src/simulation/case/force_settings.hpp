#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bit/areas/area_rules.hpp"
#include "bit/bit.hpp"
#include "bit/wear/wear.hpp"
#include "core/config/config.hpp"
#include "forces/law.hpp"
#include "forces/rock/rock_material.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::simulation {

/// The source of the area cut by a face: the section ahead of it [+], or the volume that it removed
/// [R].
enum class CutMeasure { section, volume };

/// The source of a chamfer's contact: the engaged edge times its width [+], or the rock triangles
/// that it moved or touches [R].
enum class ChamferMeasure { edge, triangles };

/// The source of the contact of a cutter's wear flat: the flat behind the engaged part of its edge
/// [+], or the rock triangles that the cutter's body moved or touches.
enum class FlatMeasure { edge, triangles };

/// The law that a table of [forces] names. Its coefficients are keys of the same table
/// (forces::law_fields).
struct LawChoice {
  std::string coefficients;  ///< a set from the literature; empty: none
  std::string law;           ///< empty: required if there are no coefficients

  static std::vector<std::string_view> fit_names();
  void visit(FieldVisitor& v) {
    v.name(coefficients, {.name = "coefficients",
                          .names = &LawChoice::fit_names,
                          .need = Need::optional,
                          .computed_default = "none",
                          .meaning = "a law with a set of coefficients from the literature; other "
                                     "keys of the table change them"});
    const std::string of_fit = law_of_fit(coefficients);
    if (!of_fit.empty()) law = of_fit;
    v.name(law, {.name = "law",
                 .names = &forces::law_names,
                 .need = law.empty() ? Need::required : Need::defaulted,
                 .computed_default =
                     "that of coefficients; without them required in [forces], and that of the "
                     "parts in [forces.KIND] and areas",
                 .meaning = "its coefficients are keys of the same table, see the tables below"});
  }

 private:
  static std::string law_of_fit(const std::string& name);
};

/// Whether a run computes forces.
enum class Forces { off, on };

/// [forces]: the force laws of a run, by kind of part or by part, and the rock in which they act.
struct ForcePlan {
  Forces forces = Forces::off;
  CutMeasure cut = CutMeasure::section;
  ChamferMeasure chamfer = ChamferMeasure::edge;
  FlatMeasure flat = FlatMeasure::triangles;
  std::array<forces::Law, bit::part_kinds.size()> laws;  ///< by PartKind
  std::vector<forces::Law> part_laws;  ///< by part if areas define laws, otherwise empty
  std::vector<std::vector<std::string>>
      part_areas;  ///< by part: the areas that select it; or empty
  forces::Formation rock;

  static constexpr TableKey table{
      "forces", "the force law of every kind of part that it supports, except cutter bodies"};
  void visit(FieldVisitor& v) {
    v(cut, {.name = "cut",
            .values = {{{"section", CutMeasure::section}, {"volume", CutMeasure::volume}}},
            .meaning =
                "what a face cuts: the section ahead of it, or its removed volume over its path"});
    v(chamfer,
      {.name = "chamfer_contact",
       .values = {{{"edge", ChamferMeasure::edge}, {"triangles", ChamferMeasure::triangles}}},
       .meaning =
           "a chamfer's contact: engaged edge times width, or the triangles that it touches"});
    v(flat,
      {.name = "flat_contact",
       .values = {{{"edge", FlatMeasure::edge}, {"triangles", FlatMeasure::triangles}}},
       .need = Need::optional,
       .computed_default = "\"edge\" with [wear], else \"triangles\"",
       .meaning = "the part of a cutter's wear flat on which the law of its body acts: the flat "
                  "behind the engaged part of its edge, or the triangles that it touches"});
  }
};

/// [forces.KIND]: another law for one kind of part.
struct KindLaw : LawChoice {
  static constexpr TableKey table{
      "forces.KIND",
      "another law for one kind of part (KIND): face, chamfer, cse, cutter_body, gage_pad, "
      "bit_body, cone, tooth; its coefficients are keys of the same table"};
};

/// [forces.areas.NAME]: another law, or other coefficients, for the parts of an area.
struct AreaLaw : LawChoice {
  static constexpr TableKey table{
      "forces.areas.NAME",
      "another law, or other coefficients, for the parts that meet all criteria given here; of "
      "several areas the one with the most specific criterion decides"};
};

/// The law of a kind of part, unless an area defines another one.
inline const forces::Law& law_of(const ForcePlan& plan, bit::PartKind kind) {
  return plan.laws[static_cast<std::size_t>(kind)];
}

/// The law of a part of this kind. `part`: index into Bit::parts.
inline const forces::Law& law_of(const ForcePlan& plan, bit::PartKind kind, int part) {
  return plan.part_laws.empty() ? law_of(plan, kind)
                                : plan.part_laws[static_cast<std::size_t>(part)];
}

/// Whether parts of this kind have a force, unless an area defines another law.
inline bool has_law(const ForcePlan& plan, bit::PartKind kind) {
  return !std::holds_alternative<forces::NoForce>(law_of(plan, kind));
}

/// Whether a part of this kind has a force.
inline bool has_law(const ForcePlan& plan, bit::PartKind kind, int part) {
  return !std::holds_alternative<forces::NoForce>(law_of(plan, kind, part));
}

/// The same for the part with this index in the bit.
inline bool has_law(const ForcePlan& plan, const bit::Bit& bit, std::size_t part) {
  return has_law(plan, bit.parts[part].kind, static_cast<int>(part));
}

/// Reads [forces] and the material of [rock] (read_formation). Without [forces], a run computes no
/// forces. Records mistakes. Adds coefficients that act on no part to `warnings`.
ForcePlan read_forces(Config& c, const bit::Bit& bit, const MeasurePlan& measure,
                      std::vector<CaseWarning>& warnings);

/// The law of a kind of part to which that of the whole run does not apply: a default for cutter
/// bodies, gage pads and bit bodies [+], and none for all others.
forces::Law own_law_of(bit::PartKind kind);

/// Whether the law of the whole run applies to parts of this kind, if it knows the kind.
bool follows_the_run(bit::PartKind kind);

/// The key of a law's coefficient.
QuantityKey key_of(const forces::LawField& field);

/// Reads the key `coefficients`: a law with coefficients from the literature. Empty if not given.
std::optional<forces::Law> read_fit(Config& c);

/// Reads the law that a table names, with its coefficients. If the table names none, the law is
/// `usual`; if that is empty, the law is required. Coefficients that the table does not give are
/// those of the key `coefficients`, otherwise the defaults of the law; those without a default are
/// required.
forces::Law read_law(Config& c, const std::string& usual);

/// Reads [forces.areas.NAME] and sets plan.part_laws and part_areas. In force_areas.cpp.
///
/// An area with `law` or `coefficients` gives its parts that law, as a table [forces.KIND] does for
/// a kind. An area with neither changes coefficients of the law that its parts have. The most
/// specific area that defines a coefficient of a part decides; an area with a law defines all of
/// its coefficients. Parts that no area selects keep the law of their kind.
///
/// Records as mistakes: those of bit::read_areas; two areas of equal rank that give a part
/// different laws or coefficients; a law that does not know the kind of a part of the area; parts
/// of several laws if none is named; an area without law and coefficients. Coefficients that act on
/// no part are added to `warnings`. `where`: the name of the bit in messages.
void read_force_areas(Config& forces, const bit::Bit& bit, const std::string& where,
                      ForcePlan& plan, std::vector<CaseWarning>& warnings);

/// A table of a case that names a law, and the kinds of part that it applies to.
struct LawTable {
  std::string name;  ///< "forces", "forces.chamfer"
  forces::Law law;   ///< as read
  std::optional<forces::Law>
      fit;  ///< of the key `coefficients`, before changes by other keys of the table
  std::vector<bit::PartKind> followers;  ///< kinds of part, even if the bit has none of them
};

/// Returns a warning for each coefficient in the table that acts on no part of the bit and could be
/// omitted: it is not required, and its value is not the default. In force_areas.cpp.
std::vector<CaseWarning> idle_coefficients(const Config& table, LawTable law_table,
                                           const bit::Bit& bit);

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
                              .computed_default = "required by sliding and thermal",
                              .range = Range::non_negative(),
                              .meaning = "of Archard's law"});
      v(sliding.hardness, {.name = "hardness",
                           .unit = "Pa",
                           .need = Need::required,
                           .computed_default = "required by sliding and thermal",
                           .range = Range::positive(),
                           .meaning = "of the worn material"});
    }
    if (v.when(law == WearKind::thermal)) {
      v(threshold, {.name = "threshold",
                    .unit = "K",
                    .need = Need::required,
                    .computed_default = "required by thermal",
                    .range = Range::positive(),
                    .meaning = "temperature limit: a hotter flat wears faster"});
      v(growth, {.name = "growth",
                 .unit = "K",
                 .range = Range::positive(),
                 .meaning = "thermal: rise of temperature that multiplies the rate by e",
                 .usual = Range::within(0.0, 1e4)});
    }
    if (v.when(law == WearKind::table)) {
      v(rates.temperatures, {.name = "temperatures",
                             .unit = "K",
                             .need = Need::required,
                             .computed_default = "required by table",
                             .meaning = "rising"});
      v(rates.rates, {.name = "rates",
                      .unit = "m3 N-1 m-1",
                      .need = Need::required,
                      .computed_default = "required by table",
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
