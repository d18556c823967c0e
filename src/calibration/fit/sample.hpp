#pragma once

#include <array>
#include <vector>

#include "calibration/cuts/cut_run.hpp"
#include "calibration/record/record.hpp"
#include "forces/law.hpp"

namespace tdbd::calibration {

/// All that the loads of one record are computed from.
struct Sample {
  std::vector<forces::PartCut> cuts;  ///< of parts that follow the law of the cutters
  Loads others{};  ///< N and N m (of a cutter: N), of parts with laws of their own
};

/// The mean cuts of a record's tool at its speed, in rock of this strength. Frame: the tool's.
Sample sample_of(const CutRun& run, const Record& record, const forces::Strength& strength,
                 const forces::Law& law);

/// Mean loads, calibration (1): the law is evaluated once on each part's mean cut. Does not
/// allocate.
Loads mean_loads(const forces::Law& law, const Sample& sample);

/// Kinds of part, by PartKind.
using Kinds = std::array<bool, bit::part_kinds.size()>;

/// What the parts of some kinds under the law add to the mean loads.
Loads loads_of(const forces::Law& law, const Sample& sample, const Kinds& kinds);

/// d log load / d log depth of each load: areas grow with the depth, edges and contacts stay.
/// 0 where there is no load.
Loads depth_slopes(const forces::Law& law, const Sample& sample);

}  // namespace tdbd::calibration
