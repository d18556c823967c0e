#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/motion.hpp"
#include "string/section.hpp"
#include "string/statics.hpp"

/// The settings of a drill string as a chain of nodes (src/string).
namespace tdbd::simulation {

/// How the string is modelled.
enum class StringModel { lumped, chain };

/// The initial state of a chain.
enum class ChainStart {
  steady,  ///< in the steady motion with the rate, speed, weight and torque of the start
  rest,    ///< at rest, untwisted, or twisted by the torque at the start if one is given
};

/// [string]: the drill string as a chain of nodes.
struct ChainSettings {
  StringModel model = StringModel::lumped;
  string::Directions directions = string::Directions::both;
  ChainStart start = ChainStart::steady;
  double hole_diameter = 0.0;  ///< 0: not given

  static constexpr TableKey table{"string", "the drill string as a chain of nodes"};
  void visit(FieldVisitor& v) {
    visit_model(v);
    v(directions, {.name = "directions",
                   .values = {{{"both", string::Directions::both},
                               {"torsion", string::Directions::torsion},
                               {"axial", string::Directions::axial}}},
                   .meaning = "in which nodes move; torsion: no tension, side forces of the weight "
                              "alone; axial: turns as its top, without friction"});
    v(start, {.name = "start",
              .values = {{{"steady", ChainStart::steady}, {"rest", ChainStart::rest}}},
              .meaning = "steady: the static profile of the initial motion; rest: the string hangs "
                         "untwisted, or twisted by motion.torque_at_start"});
    v(hole_diameter,
      {.name = "hole_diameter",
       .unit = "m",
       .need = Need::optional,
       .computed_default = "of a bit that drills, its gage diameter; else none: no warning",
       .range = Range::positive(),
       .meaning = "warns where the string is compressed beyond its sinusoidal buckling",
       .usual = Range::within(0.0, 1.5)});
  }
  void visit_model(FieldVisitor& v) {
    v(model,
      {.name = "model",
       .values = {{{"lumped", StringModel::lumped}, {"chain", StringModel::chain}}},
       .meaning = "lumped: a spring per direction; chain: nodes from the surface to the bit"});
  }
};

/// Reads only string.model.
StringModel read_string_model(Config& string);

/// The elements of a chain, in [string]. The default depends on its sections.
struct ChainElements {
  double element_length = 0.0;

  void visit(FieldVisitor& v) {
    v(element_length,
      {.name = "element_length",
       .unit = "m",
       .computed_default = "10 m, or what the time step allows; rounded to whole elements",
       .range = Range::positive(),
       .meaning = "of the elements of the chain"});
  }
};

/// A bit without a shape and what is rigidly connected to it, in [string].
struct ChainEnd {
  double mass = 0.0, torsional_inertia = 0.0;

  void visit(FieldVisitor& v) {
    v(mass, {.name = "mass",
             .unit = "kg",
             .range = up_to_largest,
             .meaning = "of the bit and what is rigid with it"});
    v(torsional_inertia, {.name = "torsional_inertia",
                          .unit = "kg m2",
                          .range = up_to_largest,
                          .meaning = "of the same about its axis"});
  }
};

/// In [string].
struct Gravity {
  double gravity = 9.80665;

  void visit(FieldVisitor& v) {
    v(gravity, {.name = "gravity",
                .unit = "m/s2",
                .range = Range::within(0.0, 100.0),
                .meaning = "downward"});
  }
};

enum class MaterialName { steel, aluminium, titanium };
string::Material material_of(MaterialName name);

/// The way in which a section is given.
enum class SectionBy { diameters, products };

/// [[string.sections]].
struct SectionSettings {
  double length = 0.0;
  string::Diameters diameters;
  MaterialName material = MaterialName::steel;
  string::Material moduli;
  double linear_mass = 0.0;  ///< 0: from the diameters
  string::Section products{.axial_rigidity = 1.0, .torsional_rigidity = 1.0};

  static constexpr TableKey table{"string.sections",
                                  "a length of pipe or collars; the topmost first", Repeats::yes};
  void visit(FieldVisitor& v, SectionBy by = SectionBy::diameters) {
    const bool is_pipe = by == SectionBy::diameters;
    v(length, {.name = "length",
               .unit = "m",
               .need = Need::required,
               .range = Range::positive(),
               .meaning = "along the hole"});
    v.only(is_pipe, {"rigidities as well", "a section by diameters or by its rigidities"}, [&] {
      v(diameters.outer, {.name = "outer_diameter",
                          .unit = "m",
                          .need = Need::required,
                          .computed_default = "required without axial_rigidity",
                          .range = Range::positive(),
                          .meaning = "of the body",
                          .usual = Range::within(0.0, 1.5)});
      v(diameters.inner, {.name = "inner_diameter",
                          .unit = "m",
                          .range = Range::non_negative(),
                          .meaning = "of the body",
                          .usual = Range::within(0.0, 1.5)});
      v(linear_mass, {.name = "linear_mass",
                      .unit = "kg/m",
                      .need = Need::optional,
                      .computed_default = "from the diameters",
                      .range = Range::positive(),
                      .meaning = "with tool joints: for weight and inertia"});
    });
    if (is_pipe) diameters.contact = diameters.outer;
    v(diameters.contact, {.name = "contact_diameter",
                          .unit = "m",
                          .computed_default = "outer_diameter",
                          .range = Range::positive(),
                          .meaning = "where it touches the hole: tool joints",
                          .usual = Range::within(0.0, 1.5)});
    if (v.when(is_pipe)) visit_material(v);
    if (v.when(!is_pipe)) visit_products(v);
  }
  void visit_material(FieldVisitor& v) {
    v(material, {.name = "material",
                 .values = {{{"steel", MaterialName::steel},
                             {"aluminium", MaterialName::aluminium},
                             {"titanium", MaterialName::titanium}}},
                 .meaning = "steel: 206 GPa, 79.3 GPa, 7850 kg/m3; aluminium: 71, 26.7, 2800; "
                            "titanium: 114, 43, 4430"});
    moduli = material_of(material);
    v(moduli.young, {.name = "young",
                     .unit = "Pa",
                     .computed_default = "of the material",
                     .range = Range::positive(),
                     .meaning = "Young's modulus",
                     .usual = Range::within(1e9, 2e12)});
    v(moduli.shear, {.name = "shear",
                     .unit = "Pa",
                     .computed_default = "of the material",
                     .range = Range::positive(),
                     .meaning = "shear modulus",
                     .usual = Range::within(1e9, 2e12)});
    v(moduli.density, {.name = "density",
                       .unit = "kg/m3",
                       .computed_default = "of the material",
                       .range = Range::positive(),
                       .meaning = "for mass and buoyancy"});
  }
  void visit_products(FieldVisitor& v) {
    v(products.axial_rigidity, {.name = "axial_rigidity",
                                .unit = "N",
                                .computed_default = "in place of diameters",
                                .range = Range::non_negative(),
                                .meaning = "E A"});
    v(products.torsional_rigidity, {.name = "torsional_rigidity",
                                    .unit = "N m2",
                                    .computed_default = "in place of diameters",
                                    .range = Range::non_negative(),
                                    .meaning = "G J"});
    v(products.mass, {.name = "mass_per_length",
                      .unit = "kg/m",
                      .computed_default = "in place of diameters",
                      .range = Range::non_negative(),
                      .meaning = "rho A"});
    v(products.inertia, {.name = "inertia_per_length",
                         .unit = "kg m",
                         .computed_default = "in place of diameters",
                         .range = Range::non_negative(),
                         .meaning = "rho J"});
    v(products.weight, {.name = "weight_per_length",
                        .unit = "N/m",
                        .computed_default = "in place of diameters",
                        .range = Range::non_negative(),
                        .meaning = "in mud; default 0"});
  }
};

/// [string.survey]: the path of the well.
struct SurveySettings {
  std::string file;
  string::Stations stations;

  static constexpr TableKey table{"string.survey", "the path of the well; vertical without it"};
  void visit(FieldVisitor& v) {
    v.path(file, {.name = "file",
                  .need = Need::optional,
                  .computed_default = "in place of the lists",
                  .meaning = "CSV with the columns md_m, inc_deg, azi_deg"});
    v.only(!v.gives("file"), {"a file as well", "a file or the lists"}, [&] {
      v(stations.depths, {.name = "measured_depth",
                          .unit = "m",
                          .need = Need::required,
                          .computed_default = "required without file",
                          .meaning = "of the stations, ascending from 0"});
      v(stations.inclinations, {.name = "inclination",
                                .unit = "rad",
                                .need = Need::required,
                                .computed_default = "required without file",
                                .meaning = "from the vertical",
                                .usual = Range::within(0.0, 3.15)});
      v(stations.azimuths, {.name = "azimuth",
                            .unit = "rad",
                            .need = Need::required,
                            .computed_default = "required without file",
                            .meaning = "from north"});
    });
  }
};

/// Friction of the string, in [string.friction] and [[string.friction.above]].
struct FrictionCoefficients {
  double resting = 0.0, sliding = 0.0;

  void visit(FieldVisitor& v) {
    v(resting, {.name = "static",
                .computed_default = "0",
                .range = Range::within(0.0, 2.0),
                .meaning = "Coulomb's coefficient at rest"});
    sliding = v.gives("static") ? resting : std::min(sliding, resting);
    v(sliding, {.name = "dynamic",
                .computed_default = "static",
                .range = Range::within(0.0, 2.0),
                .meaning = "Coulomb's coefficient in motion"});
  }
};

/// [[string.friction.above]].
struct FrictionAbove {
  double depth = 0.0;
  FrictionCoefficients coefficients;

  static constexpr TableKey table{"string.friction.above", "friction above a depth: cased hole",
                                  Repeats::yes};
  void visit(FieldVisitor& v) {
    v(depth, {.name = "depth",
              .unit = "m",
              .need = Need::required,
              .range = Range::positive(),
              .meaning = "down to which these coefficients hold"});
    coefficients.visit(v);
  }
};

/// [string.friction]: the resistance against the motion of the string.
struct StringDamping {
  double threshold = 0.0, mud_density = 0.0;
  double axial_damping = 0.1, torsional_damping = 0.1;
  double axial_loss_time = 0.0;

  static constexpr TableKey table{"string.friction", "what resists the string's motion"};
  void visit(FieldVisitor& v) {
    v(threshold, {.name = "threshold",
                  .unit = "m/s",
                  .range = Range::non_negative(),
                  .meaning = "slip up to which friction is that at rest"});
    v(mud_density, {.name = "mud_density",
                    .unit = "kg/m3",
                    .range = Range::non_negative(),
                    .meaning = "for buoyancy; 0: none"});
    v(axial_damping, {.name = "axial_damping",
                      .unit = "1/s",
                      .range = Range::within(0.0, 1e6),
                      .meaning = "by the mud, per mass"});
    v(torsional_damping, {.name = "torsional_damping",
                          .unit = "1/s",
                          .range = Range::within(0.0, 1e6),
                          .meaning = "by the mud, per inertia"});
    v(axial_loss_time, {.name = "axial_loss_time",
                        .unit = "s",
                        .range = Range::non_negative(),
                        .meaning = "Kelvin-Voigt's damping of stretch"});
  }
};

/// In [string.friction]. The default depends on the coefficients of friction.
struct TorsionalLoss {
  double time = 0.0;

  void visit(FieldVisitor& v) {
    v(time, {.name = "torsional_loss_time",
             .unit = "s",
             .computed_default = "0; 0.1 steps where friction at rest is larger",
             .range = Range::non_negative(),
             .meaning = "Kelvin-Voigt's damping of twist"});
  }
};

/// The sections of a string on a chain, and its position in the well.
struct StringPlan {
  std::vector<string::Section> sections;
  string::Survey survey;
  std::vector<string::FrictionBelow> friction;          ///< by depth, downward
  double threshold = 0.0;                               ///< m/s
  double axial_damping = 0.0, torsional_damping = 0.0;  ///< 1/s
  double axial_loss_time = 0.0;                         ///< s
  double torsional_loss_time = 0.0;                     ///< s
  double hole_diameter = 0.0;                           ///< m; 0: not given
};

/// The output of a string on a chain, in [output].
struct ChainOutputSettings {
  std::vector<double> string_depths;
  double string_profile_every = 0.0;  ///< 0: none

  void visit(FieldVisitor& v) {
    v(string_depths, {.name = "string_depths",
                      .unit = "m",
                      .computed_default = "none",
                      .meaning = "measured depths of nodes in the history, each the nearest node"});
    v(string_profile_every, {.name = "string_profile_every",
                             .unit = "s",
                             .need = Need::optional,
                             .computed_default = "none: no string.nc",
                             .range = Range::positive(),
                             .meaning = "time between profiles over all nodes"});
  }
};

/// The output of a string on a chain.
struct ChainOutput {
  std::vector<int> nodes;  ///< in the history
  long profile_every = 0;  ///< steps between profiles of all nodes; 0: none
};

}  // namespace tdbd::simulation
