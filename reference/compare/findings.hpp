#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reference/compare/quantity.hpp"

namespace tdbd::reference {

/// A model's result for one quantity: either a value, or the reason why there is none.
struct QuantityResult {
  std::optional<double> value;
  std::string reason;
};

/// A model's result for one cutter, tooth, row of teeth or cone.
struct PartFinding {
  std::string part;     ///< "cutter-12", "cone-1", "cone-1/row-2", "cone-1/row-2/tooth-3"
  double radius = 0.0;  ///< m, from the bit's axis; 0 for a cone
  PartQuantity quantity = PartQuantity::area;
  double value = 0.0;
};

/// Parts of a bit contain each other, so values of different levels must not be summed.
enum class PartLevel { cutter, cone, row, tooth };

/// The level according to the part's name.
PartLevel level_of(const PartFinding& finding);

/// Loads of the steps over which means are taken.
struct LoadSeries {
  double step = 0.0;                   ///< s
  std::vector<double> weight, torque;  ///< N, N m
};

/// The bottom along a circle about the hole's axis.
struct BottomCircle {
  double radius = 0.0;        ///< m
  std::vector<double> depth;  ///< m, z down; at equal angles from azimuth 0
};

/// Run time of a model.
struct Cost {
  double cpu = 0.0;        ///< s, of this process; 0: not measured yet
  double simulated = 0.0;  ///< s; 0: no time in the model
  long steps = 0;
};

/// All results of a model for a case.
struct Findings {
  std::array<QuantityResult, quantity_count> says;
  std::vector<PartFinding> parts;
  LoadSeries series;                   ///< empty if the model is steady
  std::optional<BottomCircle> bottom;  ///< empty if the model has no bottom
  std::vector<std::string> notes;      ///< assumptions and limitations that affect the values
  Cost cost;
};

inline QuantityResult& saying(Findings& f, Quantity q) {
  return f.says[static_cast<std::size_t>(q)];
}
inline const QuantityResult& saying(const Findings& f, Quantity q) {
  return f.says[static_cast<std::size_t>(q)];
}

void say(Findings& f, Quantity q, double value);
void set_missing(Findings& f, Quantity q, const std::string& reason);

/// Sets the reason for every quantity of the list that has neither value nor reason.
void set_missing(Findings& f, const std::vector<Quantity>& quantities, const std::string& reason);

/// Sets weight, torque, the work per revolution and the noise of steps, from a series. `advance`: m
/// per revolution.
void set_load_quantities(Findings& f, const LoadSeries& series, double advance);

/// Sets weight, torque and the work per revolution of a steady model, whose steps have no noise.
void set_steady_load_quantities(Findings& f, double weight, double torque, double advance);

/// Mean of means over `steps_together` steps, and rms deviation from it over the mean.
struct Noise {
  double mean = 0.0, share = 0.0;
};
Noise noise_of(const std::vector<double>& values, std::size_t steps_together);

}  // namespace tdbd::reference
