#pragma once

#include <array>
#include <span>
#include <vector>

#include "calibration/cuts/cut_run.hpp"
#include "calibration/record/record.hpp"
#include "forces/law.hpp"

namespace tdbd::calibration {

/// The data from which the loads of one record are computed.
struct Sample {
  std::vector<forces::PartCut> cuts;  ///< of parts that use the law of the cutters
  std::vector<int> mix;               ///< mix of each cut (AreaLaws); empty: all 0
  Loads others{};                     ///< N and N m (cutter: N), of parts with their own laws
};

/// The mean cuts of a record's tool at its speed, in rock of this strength. The frame is that of
/// the tool. `mix_of_part` has one entry per part of the tool; empty: all 0.
Sample sample_of(const CutRun& run, const Record& record, const forces::Strength& strength,
                 const forces::Law& law, std::span<const int> mix_of_part = {});

/// A law, or one per mix of coefficients (AreaLaws).
using Laws = std::span<const forces::Law>;

/// Mean loads, calibration (1): the law is evaluated once for the mean cut of each part. Does not
/// allocate.
Loads mean_loads(Laws laws, const Sample& sample);
inline Loads mean_loads(const forces::Law& law, const Sample& sample) {
  return mean_loads(Laws(&law, 1), sample);
}

/// Flags for kinds of part, indexed by PartKind.
using Kinds = std::array<bool, bit::part_kinds.size()>;

/// Contribution to the mean loads of the parts of some kinds under the law.
Loads loads_of(Laws laws, const Sample& sample, const Kinds& kinds);

/// d log load / d log depth of each load: areas grow with the depth, edges and contacts are
/// constant. 0 if there is no load.
Loads depth_slopes(Laws laws, const Sample& sample);
inline Loads depth_slopes(const forces::Law& law, const Sample& sample) {
  return depth_slopes(Laws(&law, 1), sample);
}

}  // namespace tdbd::calibration
