#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/literature/drag/drag_rock.hpp"
#include "reference/literature/drag/plane/planar_outline.hpp"
#include "reference/literature/drag/spokes/hanson_hansen_law.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::reference {

/// Settings of Glowka's model in addition to the rock that drag-bit models share.
struct GlowkaSettings {
  double power = 0.0, reference_depth = 0.0;            ///< 1, m
  std::optional<double> flat_stress, wear_coefficient;  ///< Pa, m3/(N m)
  double distance = 0.0;                                ///< m
  double flat_friction = 0.0, rock_conductivity = 0.0, rock_diffusivity = 0.0,
         cutter_resistance = 0.0;
};

/// Settings of models of roller bits. Missing values are derived from the case (compare_keys.hpp).
struct RollerSettings {
  std::optional<double> specific_energy;  ///< Pa
  double normal_ratio = 0.0, half_angle = 0.0;
  std::string tooth_table;
  std::optional<double> penetration, cone_ratio;  ///< m, 1
  double tooth_half_angle = 0.0;                  ///< rad
};

/// Known rates, to which the constants of Winters, Warren and Onyia are fitted.
struct WintersSettings {
  std::vector<double> weights, rates;  ///< N, m/s
  double strength = 0.0;               ///< Pa
};

/// Settings of the comparison ([compare]).
struct CompareOptions {
  std::vector<std::string> models;  ///< "all", or names
  double counted_revolutions = 1.0;
  std::optional<double> weight_on_bit;  ///< N
  double circle = 0.0;                  ///< m
  int circle_samples = 0;
  OutlineForm outline = OutlineForm::planar;
  int planes = 0, plane_nodes = 0;
  int spokes = 0, spoke_nodes = 0;
  double spoke_spacing = 0.0;  ///< m
  GlowkaSettings glowka;
  RollerSettings roller;
  WintersSettings winters;
};

/// One bit, one rock, one schedule: a case of tdbd run with the table [compare].
struct CompareCase {
  simulation::Case ours;
  CompareOptions options;
  /// The law of the faces in the form of models of drag bits; empty if the case has another law.
  std::optional<DragRock> rock;           ///< "detournay": linear in the area
  std::optional<EdgeCoefficients> edges;  ///< "hanson-hansen", in rock of one strength
  std::optional<DragRock> tips;           ///< "depth-of-cut": linear in width times depth
  double advance = 0.0;                   ///< m per revolution; for a bit on a string, at its start
  std::string resolved;                   ///< TOML
};

/// Reads and checks a case without running anything. The motion is steady or whirl (prescribed,
/// with a rotary speed) or drilling (a bit on a string). Throws InputError that lists every
/// mistake.
CompareCase read_compare_case(const std::string& path, const std::vector<std::string>& overrides);

/// Whether the bit is on a string and its motion is free.
bool is_free(const CompareCase& c);

/// Number of TDBD steps over which means are taken, according to the nominal rotary speed.
long counted_steps(const CompareCase& c);

}  // namespace tdbd::reference
