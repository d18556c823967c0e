#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reference/compare/quantity.hpp"

namespace tdbd::reference {

/// What a model says about one quantity: a number, or why it has none. Exactly one of them.
struct Saying {
  std::optional<double> value;
  std::string reason;
};

/// What it says about one cutter; or one tooth, one row of teeth, one cone.
struct PartFinding {
  std::string part;     ///< "cutter-12", "cone-1", "cone-1/row-2", "cone-1/row-2/tooth-3"
  double radius = 0.0;  ///< m, from the bit's axis; 0 of a cone
  PartQuantity quantity = PartQuantity::area;
  double value = 0.0;
};

/// A bit's parts contain each other: values of different levels are not summed.
enum class PartLevel { cutter, cone, row, tooth };

/// By the part's name.
PartLevel level_of(const PartFinding& finding);

/// Loads of the steps that count.
struct LoadSeries {
  double step = 0.0;                   ///< s
  std::vector<double> weight, torque;  ///< N, N m
};

/// The bottom along a circle about the hole's axis.
struct BottomCircle {
  double radius = 0.0;        ///< m
  std::vector<double> depth;  ///< m, z down; at equal angles from azimuth 0
};

/// What a model cost.
struct Cost {
  double cpu = 0.0;        ///< s, of this process; 0: still to be measured
  double simulated = 0.0;  ///< s; 0: no time in the model
  long steps = 0;
};

/// All that a model says about a case.
struct Findings {
  std::array<Saying, quantity_count> says;
  std::vector<PartFinding> parts;
  LoadSeries series;                   ///< empty: the model is steady
  std::optional<BottomCircle> bottom;  ///< none: the model keeps no bottom
  std::vector<std::string> notes;      ///< what a reader of its numbers must know
  Cost cost;
};

inline Saying& saying(Findings& f, Quantity q) { return f.says[static_cast<std::size_t>(q)]; }
inline const Saying& saying(const Findings& f, Quantity q) {
  return f.says[static_cast<std::size_t>(q)];
}

void say(Findings& f, Quantity q, double value);
void cannot_say(Findings& f, Quantity q, const std::string& reason);

/// Gives the reason to every quantity of the list that has neither value nor reason.
void cannot_say(Findings& f, const std::vector<Quantity>& quantities, const std::string& reason);

/// Weight, torque, the work of a turn and the noise of steps, from a series; `advance`: m a
/// revolution.
void say_loads(Findings& f, const LoadSeries& series, double advance);

/// Weight, torque and the work of a turn of a steady model, whose steps have no noise.
void say_steady_loads(Findings& f, double weight, double torque, double advance);

/// Mean, and rms deviation from it over the mean, of means over so many steps.
struct Noise {
  double mean = 0.0, share = 0.0;
};
Noise noise_of(const std::vector<double>& values, std::size_t steps_together);

}  // namespace tdbd::reference
