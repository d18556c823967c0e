#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// At what speeds a bit's cones are looked at, and how deep their teeth stand in the bottom.
struct ConeOperation {
  std::vector<double> cone_speeds;  ///< over the bit's, one for each cone, > 0
  double penetration = 5e-3;        ///< m
};

/// The speeds given, or each cone's rolling ratio of its gage row when none is. Throws InputError
/// (--cone-speeds) when their number is not that of the cones, or one of them is not above 0.
ConeOperation cone_operation(const Bit& bit, const std::vector<double>& cone_speeds,
                             double penetration);

/// Adds to analysis.json, to each of its `cones` and their `rows`, how often the teeth fall into
/// earlier prints and how many stand on the bottom at once (bit/cone/tracking.hpp,
/// bit/cone/tooth_prints.hpp); and `tracking`, the same of the whole bit with a sweep of the cones'
/// speed. Nothing for a bit without cones.
void add_tracking(const Bit& bit, const ConeOperation& operation, nlohmann::ordered_json& file);

/// The rows' figures as lines for a reader.
std::string tracking_text(const Bit& bit, const ConeOperation& operation);

}  // namespace tdbd::bit
