#pragma once

#include "core/config/key.hpp"
#include "simulation/case/motion_keys.hpp"
#include "string/simple_bit.hpp"

/// The keys of a drill string as a chain of nodes (src/string).
namespace tdbd::simulation {

/// How the string is modelled.
enum class StringModel { lumped, chain };

/// How a chain starts.
enum class ChainStart {
  steady,  ///< in the steady motion of the start's rate, speed, weight and torque
  rest,    ///< hangs unturned; with the torque at the start where one is given
};

/// Top drives as a case names them.
enum class TopDrive { speed, pi, soft_torque, z_torque };

namespace chain_keys {

inline constexpr TableKey table{"string", "the drill string as a chain of nodes"};

inline constexpr ChoiceKey<StringModel> model{
    .name = "model",
    .values = {{{"lumped", StringModel::lumped}, {"chain", StringModel::chain}}},
    .fallback = StringModel::lumped,
    .meaning = "lumped: a spring per direction; chain: nodes from the surface to the bit"};
inline constexpr ChoiceKey<string::Directions> directions{
    .name = "directions",
    .values = {{{"both", string::Directions::both},
                {"torsion", string::Directions::torsion},
                {"axial", string::Directions::axial}}},
    .fallback = string::Directions::both,
    .meaning =
        "in which nodes move; torsion: no tension, side forces of the weight alone; axial: "
        "turns as its top, without friction"};
inline constexpr QuantityKey element_length{
    .name = "element_length",
    .unit = "m",
    .usual = "10 m, or what the time step allows; rounded to whole elements",
    .range = Range::positive(),
    .meaning = "of the elements of the chain"};
inline constexpr ChoiceKey<ChainStart> start{
    .name = "start",
    .values = {{{"steady", ChainStart::steady}, {"rest", ChainStart::rest}}},
    .fallback = ChainStart::steady,
    .meaning =
        "steady: the static profile of the start's motion; rest: hangs, the top unturned or "
        "with motion.torque_at_start"};
inline constexpr QuantityKey mass{.name = "mass",
                                  .unit = "kg",
                                  .fallback = 0.0,
                                  .range = up_to_largest,
                                  .meaning = "of the bit and what is rigid with it"};
inline constexpr QuantityKey torsional_inertia{.name = "torsional_inertia",
                                               .unit = "kg m2",
                                               .fallback = 0.0,
                                               .range = up_to_largest,
                                               .meaning = "of the same about its axis"};
inline constexpr QuantityKey gravity{.name = "gravity",
                                     .unit = "m/s2",
                                     .fallback = 9.80665,
                                     .range = Range::within(0.0, 100.0),
                                     .meaning = "downward"};
inline constexpr QuantityKey hole_diameter{
    .name = "hole_diameter",
    .unit = "m",
    .usual = "of a bit that drills, its gage diameter; else none: no warning",
    .range = Range::positive(),
    .meaning = "warns where the string is compressed beyond its sinusoidal buckling"};

}  // namespace chain_keys

namespace section_keys {

inline constexpr TableKey table{"string.sections", "a length of pipe or collars; the topmost first",
                                Repeats::yes};

inline constexpr QuantityKey length{
    .name = "length", .unit = "m", .range = Range::positive(), .meaning = "along the hole"};
inline constexpr QuantityKey outer_diameter{.name = "outer_diameter",
                                            .unit = "m",
                                            .usual = "required without axial_rigidity",
                                            .range = Range::positive(),
                                            .meaning = "of the body"};
inline constexpr QuantityKey inner_diameter{.name = "inner_diameter",
                                            .unit = "m",
                                            .fallback = 0.0,
                                            .range = Range::non_negative(),
                                            .meaning = "of the body"};
inline constexpr QuantityKey contact_diameter{.name = "contact_diameter",
                                              .unit = "m",
                                              .usual = "outer_diameter",
                                              .range = Range::positive(),
                                              .meaning = "where it touches the hole: tool joints"};
enum class MaterialName { steel, aluminium, titanium };
inline constexpr ChoiceKey<MaterialName> material{
    .name = "material",
    .values = {{{"steel", MaterialName::steel},
                {"aluminium", MaterialName::aluminium},
                {"titanium", MaterialName::titanium}}},
    .fallback = MaterialName::steel,
    .meaning =
        "steel: 206 GPa, 79.3 GPa, 7850 kg/m3; aluminium: 71, 26.7, 2800; titanium: 114, "
        "43, 4430"};
inline constexpr QuantityKey young{.name = "young",
                                   .unit = "Pa",
                                   .usual = "of the material",
                                   .range = Range::positive(),
                                   .meaning = "Young's modulus"};
inline constexpr QuantityKey shear{.name = "shear",
                                   .unit = "Pa",
                                   .usual = "of the material",
                                   .range = Range::positive(),
                                   .meaning = "shear modulus"};
inline constexpr QuantityKey density{.name = "density",
                                     .unit = "kg/m3",
                                     .usual = "of the material",
                                     .range = Range::positive(),
                                     .meaning = "for mass and buoyancy"};
inline constexpr QuantityKey linear_mass{.name = "linear_mass",
                                         .unit = "kg/m",
                                         .usual = "from the diameters",
                                         .range = Range::positive(),
                                         .meaning = "with tool joints: for weight and inertia"};
/// Of a section given by its products instead of its diameters.
constexpr QuantityKey product(std::string_view name, std::string_view unit,
                              std::string_view meaning) {
  return {.name = name,
          .unit = unit,
          .usual = "in place of diameters",
          .range = Range::non_negative(),
          .meaning = meaning};
}
inline constexpr QuantityKey axial_rigidity = product("axial_rigidity", "N", "E A");
inline constexpr QuantityKey torsional_rigidity = product("torsional_rigidity", "N m2", "G J");
inline constexpr QuantityKey mass_per_length = product("mass_per_length", "kg/m", "rho A");
inline constexpr QuantityKey inertia_per_length = product("inertia_per_length", "kg m", "rho J");
inline constexpr QuantityKey weight_per_length =
    product("weight_per_length", "N/m", "in mud; default 0");

}  // namespace section_keys

namespace survey_keys {

inline constexpr TableKey table{"string.survey", "the path of the well; vertical without it"};

inline constexpr PathKey file{.name = "file",
                              .usual = "in place of the lists",
                              .meaning = "CSV with the columns md_m, inc_deg, azi_deg"};
inline constexpr ListKey measured_depth{.name = "measured_depth",
                                        .unit = "m",
                                        .usual = "required without file",
                                        .meaning = "of the stations, ascending from 0"};
inline constexpr ListKey inclination{.name = "inclination",
                                     .unit = "rad",
                                     .usual = "required without file",
                                     .meaning = "from the vertical"};
inline constexpr ListKey azimuth{
    .name = "azimuth", .unit = "rad", .usual = "required without file", .meaning = "from north"};

}  // namespace survey_keys

namespace string_friction_keys {

inline constexpr TableKey table{"string.friction", "what resists the string's motion"};
inline constexpr TableKey above{"string.friction.above", "friction above a depth: cased hole",
                                Repeats::yes};

constexpr QuantityKey coefficient(std::string_view name, std::string_view usual,
                                  std::string_view meaning) {
  return {.name = name, .usual = usual, .range = Range::within(0.0, 2.0), .meaning = meaning};
}
inline constexpr QuantityKey resting = coefficient("static", "0", "Coulomb's coefficient at rest");
inline constexpr QuantityKey sliding =
    coefficient("dynamic", "static", "Coulomb's coefficient in motion");
inline constexpr QuantityKey threshold{.name = "threshold",
                                       .unit = "m/s",
                                       .fallback = 0.0,
                                       .range = Range::non_negative(),
                                       .meaning = "slip up to which friction is that at rest"};
inline constexpr QuantityKey depth{.name = "depth",
                                   .unit = "m",
                                   .range = Range::positive(),
                                   .meaning = "down to which these coefficients hold"};
inline constexpr QuantityKey mud_density{.name = "mud_density",
                                         .unit = "kg/m3",
                                         .fallback = 0.0,
                                         .range = Range::non_negative(),
                                         .meaning = "for buoyancy; 0: none"};
constexpr QuantityKey rate(std::string_view name, double fallback, std::string_view meaning) {
  return {.name = name,
          .unit = "1/s",
          .fallback = fallback,
          .range = Range::within(0.0, 1e6),
          .meaning = meaning};
}
inline constexpr QuantityKey axial_damping = rate("axial_damping", 0.1, "by the mud, per mass");
inline constexpr QuantityKey torsional_damping =
    rate("torsional_damping", 0.1, "by the mud, per inertia");
inline constexpr QuantityKey axial_loss_time{.name = "axial_loss_time",
                                             .unit = "s",
                                             .fallback = 0.0,
                                             .range = Range::non_negative(),
                                             .meaning = "Kelvin-Voigt's damping of stretch"};
inline constexpr QuantityKey torsional_loss_time{
    .name = "torsional_loss_time",
    .unit = "s",
    .usual = "0; 0.1 steps where friction at rest is larger",
    .range = Range::non_negative(),
    .meaning = "Kelvin-Voigt's damping of twist"};

}  // namespace string_friction_keys

namespace top_keys {

inline constexpr TableKey table{"string.top", "what drives the top of the string"};

inline constexpr ChoiceKey<TopDrive> torsion{
    .name = "torsion",
    .values = {{{"speed", TopDrive::speed},
                {"pi", TopDrive::pi},
                {"soft-torque", TopDrive::soft_torque},
                {"z-torque", TopDrive::z_torque}}},
    .fallback = TopDrive::speed,
    .meaning =
        "speed: turns with motion.rotary_speed; the others: an inertia under control, that "
        "speed its set point"};
inline constexpr QuantityKey inertia{.name = "inertia",
                                     .unit = "kg m2",
                                     .usual = "required, except speed",
                                     .range = Range::positive(),
                                     .meaning = "of the top drive"};
inline constexpr QuantityKey proportional{.name = "proportional",
                                          .unit = "N m s/rad",
                                          .usual = "pi: required; else from impedance_factor",
                                          .range = Range::non_negative(),
                                          .meaning = "gain of the speed"};
inline constexpr QuantityKey integral{.name = "integral",
                                      .unit = "N m/rad",
                                      .usual = "pi, z-torque: required; else from the frequency",
                                      .range = Range::non_negative(),
                                      .meaning = "gain of the angle"};
inline constexpr QuantityKey tuned_frequency{.name = "tuned_frequency",
                                             .unit = "Hz",
                                             .usual = "the string's first torsional frequency",
                                             .range = Range::positive(),
                                             .meaning = "soft-torque: where least is reflected"};
inline constexpr QuantityKey impedance_factor{.name = "impedance_factor",
                                              .fallback = 1.0,
                                              .range = Range::positive(),
                                              .meaning =
                                                  "proportional gain over the impedance of "
                                                  "the top section"};
inline constexpr QuantityKey compensation{.name = "compensation",
                                          .fallback = 0.0,
                                          .range = Range::within(0.0, 0.95),
                                          .meaning = "z-torque: share of the inertia"};
inline constexpr QuantityKey torque_limit{.name = "torque_limit",
                                          .unit = "N m",
                                          .usual = "none",
                                          .range = Range::positive(),
                                          .meaning = "of the motor"};
inline constexpr ChoiceKey<string::Top::Axial> axial{
    .name = "axial",
    .values = {{{"rate", string::Top::Axial::rate},
                {"hook-load", string::Top::Axial::hook_load},
                {"autodriller", string::Top::Axial::autodriller}}},
    .fallback = string::Top::Axial::rate,
    .meaning =
        "rate: lowered with motion.rate_of_penetration; hook-load: hangs from a force; "
        "autodriller: keeps motion.weight_on_bit at the surface"};
inline constexpr QuantityKey hook_load{.name = "hook_load",
                                       .unit = "N",
                                       .usual = "that of the start",
                                       .range = up_to_largest,
                                       .meaning = "axial = hook-load: the force"};
inline constexpr QuantityKey gain{.name = "gain",
                                  .unit = "m/s/N",
                                  .usual = "autodriller: required",
                                  .range = Range::non_negative(),
                                  .meaning = "of the weight's error"};
inline constexpr QuantityKey integral_gain{.name = "integral_gain",
                                           .unit = "m/s2/N",
                                           .usual = "autodriller: required",
                                           .range = Range::non_negative(),
                                           .meaning = "of its integral"};
inline constexpr QuantityKey filter{.name = "filter",
                                    .unit = "s",
                                    .fallback = 0.5,
                                    .range = Range::non_negative(),
                                    .meaning = "autodriller: time constant of the measured weight"};
inline constexpr ListKey rate_limits{.name = "rate_limits",
                                     .unit = "m/s",
                                     .usual = "autodriller: 0 to 60 m/h",
                                     .meaning = "slowest and fastest rate of the block"};

}  // namespace top_keys

namespace simple_bit_keys {

inline constexpr TableKey table{"string.bit", "a bit without a shape, for runs without rock"};

inline constexpr ChoiceKey<string::BitLaw> law{
    .name = "law",
    .values = {{{"none", string::BitLaw::none},
                {"fixed", string::BitLaw::fixed},
                {"two-level", string::BitLaw::two_level},
                {"regenerative", string::BitLaw::regenerative},
                {"load", string::BitLaw::load}}},
    .fallback = string::BitLaw::none,
    .meaning =
        "none: off bottom; fixed: it cannot move; two-level: Coulomb friction about the "
        "axis; regenerative: cuts what the blade ahead left; load: constant"};
inline constexpr QuantityKey weight{.name = "weight",
                                    .unit = "N",
                                    .fallback = 0.0,
                                    .meaning = "constant part of the weight on bit"};
inline constexpr QuantityKey torque{.name = "torque",
                                    .unit = "N m",
                                    .fallback = 0.0,
                                    .meaning = "constant part of the torque on bit"};
constexpr QuantityKey of_law(std::string_view name, std::string_view unit, std::string_view usual,
                             std::string_view meaning) {
  return {.name = name, .unit = unit, .usual = usual, .range = up_to_largest, .meaning = meaning};
}
inline constexpr QuantityKey resting =
    of_law("static", "N m", "two-level: required", "torque that it holds at rest");
inline constexpr QuantityKey sliding =
    of_law("dynamic", "N m", "two-level: required", "torque that it takes in motion");
inline constexpr QuantityKey force_per_depth = of_law(
    "axial_stiffness", "N/m", "regenerative: required", "force of all blades by the depth of one");
inline constexpr QuantityKey torque_per_depth = of_law(
    "torsional_stiffness", "N", "regenerative: required", "torque of all blades by that depth");
inline constexpr QuantityKey contact_force =
    of_law("contact_force", "N", "0", "regenerative: on wear flats while it advances");
inline constexpr QuantityKey contact_lever =
    of_law("contact_lever", "m", "0", "regenerative: torque over that force");
inline constexpr QuantityKey pitch{.name = "pitch",
                                   .unit = "rad",
                                   .usual = "regenerative: required",
                                   .range = Range::positive(),
                                   .meaning = "angle between blades"};
inline constexpr QuantityKey axial_damping =
    of_law("axial_damping", "N s/m", "0", "to rest, beside that of the mud");
inline constexpr QuantityKey torsional_damping =
    of_law("torsional_damping", "N m s/rad", "0", "to rest, beside that of the mud");

}  // namespace simple_bit_keys

namespace chain_output_keys {

inline constexpr TableKey table{"output", "what is recorded"};

inline constexpr IntegerKey history_every{.name = "history_every",
                                          .usual = "at most 10 000 rows",
                                          .lo = 1,
                                          .hi = 1'000'000'000,
                                          .meaning = "steps between rows of the history"};
inline constexpr ListKey string_depths{
    .name = "string_depths",
    .unit = "m",
    .usual = "none",
    .meaning = "measured depths of nodes in the history, each the nearest node"};
inline constexpr QuantityKey string_profile_every{
    .name = "string_profile_every",
    .unit = "s",
    .usual = "none: no string.nc",
    .range = Range::positive(),
    .meaning = "time between profiles over all nodes"};

}  // namespace chain_output_keys

}  // namespace tdbd::simulation
