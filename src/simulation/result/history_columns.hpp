#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "io/record.hpp"
#include "rock/section/contact_area.hpp"
#include "rock/section/section.hpp"
#include "simulation/result/figures.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::simulation {

/// The wear at a step.
struct WearRow {
  double distance = 0.0;                                  ///< m, as in WearFigures
  std::vector<double> width, volume, temperature, force;  ///< m, m3, K, N, per cutter
  std::vector<double> lost_height, part_volume;           ///< m, m3, per tooth or pad that wears
};

/// The values of one step in the history. Frames: W space (z down), B bit.
struct HistoryRow {
  double time = 0.0;                               ///< s, at the end of the step
  Vec3 p_WB = Vec3::Zero();                        ///< m, origin of the bit frame
  Vec3 rotation_vector = Vec3::Zero();             ///< rad, attitude B to W
  double rotation_angle = 0.0;                     ///< rad about the bit's axis, unwrapped
  double removed_volume_total = 0.0;               ///< m3, by all parts since the start
  std::span<const double> removed_volume_by_part;  ///< m3, in this step
  std::span<const double> cone_angles;             ///< rad, about the cones' Z since the start
  std::span<const double> cone_speeds;             ///< rad/s, in this step
  std::span<const rock::Section> sections;         ///< per cutter, at the end of the step
  std::span<const rock::PartContact> contacts;     ///< per part, at the end of the step
  const DriveRow* drive = nullptr;                 ///< null unless forces move the bit
  std::span<const double> nodes;       ///< append_nodes; empty without a string on a chain
  const LoadedStep* loaded = nullptr;  ///< forces in the step; null for a run without forces
  const WearRow* wear = nullptr;       ///< null unless the bit wears
  long swept_vertices = 0;             ///< rock vertices moved in this step
  long rock_triangles = 0;             ///< triangles of the rock surface
};

/// A part as named in the history.
struct HistoryPart {
  std::string name;  ///< "cutter-12/face"
  std::string kind;  ///< "face"
};

/// The other contents of a history, besides the bit as a whole and its parts. Empty members are not
/// recorded.
struct HistoryExtent {
  std::vector<std::string> cones;
  std::vector<std::string> cutters;  ///< cutters whose sections are measured
  bool contact_areas = false;
  bool forces = false;
  bool drive = false;
  bool chain = false;                                 ///< whether the string is a chain
  std::vector<std::string> nodes;                     ///< node_names of the nodes with columns
  std::vector<std::string> worn_cutters, worn_parts;  ///< pieces of a bit that wears
};

/// Returns the columns of a step: those of the bit, the removed volume of every part, and the other
/// contents. Each column specifies how it is combined in a row of many steps.
RecordLayout step_layout(const std::vector<HistoryPart>& parts, const HistoryExtent& extent);

/// Writes the values of a step, in the order of its columns, to `numbers`, which is overwritten.
void numbers_of(const HistoryRow& step, const HistoryExtent& extent, std::vector<double>& numbers);

}  // namespace tdbd::simulation
