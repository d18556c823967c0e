#pragma once

#include <array>
#include <span>
#include <vector>

#include "calibration/cuts/cut_run.hpp"
#include "calibration/record/record.hpp"
#include "forces/law.hpp"

namespace tdbd::calibration {

/// All that the loads of one record are computed from.
struct Sample {
  std::vector<forces::PartCut> cuts;  ///< of parts that follow the law of the cutters
  std::vector<int> mix;               ///< of each (AreaLaws); empty: all 0
  Loads others{};  ///< N and N m (of a cutter: N), of parts with laws of their own
};

/// The mean cuts of a record's tool at its speed, in rock of this strength. Frame: the tool's.
/// `mix_of_part`: of the tool's parts; empty: all 0.
Sample sample_of(const CutRun& run, const Record& record, const forces::Strength& strength,
                 const forces::Law& law, std::span<const int> mix_of_part = {});

/// A law, or one for each mix of coefficients (AreaLaws).
using Laws = std::span<const forces::Law>;

/// Mean loads, calibration (1): the law is evaluated once on each part's mean cut. Does not
/// allocate.
Loads mean_loads(Laws laws, const Sample& sample);
inline Loads mean_loads(const forces::Law& law, const Sample& sample) {
  return mean_loads(Laws(&law, 1), sample);
}

/// Kinds of part, by PartKind.
using Kinds = std::array<bool, bit::part_kinds.size()>;

/// What the parts of some kinds under the law add to the mean loads.
Loads loads_of(Laws laws, const Sample& sample, const Kinds& kinds);

/// d log load / d log depth of each load: areas grow with the depth, edges and contacts stay.
/// 0 where there is no load.
Loads depth_slopes(Laws laws, const Sample& sample);
inline Loads depth_slopes(const forces::Law& law, const Sample& sample) {
  return depth_slopes(Laws(&law, 1), sample);
}

}  // namespace tdbd::calibration
