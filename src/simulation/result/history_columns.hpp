#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "io/record.hpp"
#include "rock/section/contact_area.hpp"
#include "rock/section/section.hpp"
#include "simulation/result/figures.hpp"
#include "simulation/step/load_figures.hpp"

namespace tdbd::simulation {

/// The wear of a step.
struct WearRow {
  double distance = 0.0;                                  ///< m of wear
  std::vector<double> width, volume, temperature, force;  ///< m, m3, K, N, per cutter
  std::vector<double> lost_height, part_volume;           ///< m, m3, per tooth or pad that wears
};

/// What one step leaves in the history. Frames: W space (z down), B bit.
struct HistoryRow {
  double time = 0.0;                               ///< s, at the end of the step
  Vec3 p_WB = Vec3::Zero();                        ///< m, origin of the bit
  Vec3 rotation_vector = Vec3::Zero();             ///< rad, attitude B to W
  double rotation_angle = 0.0;                     ///< rad about the bit's axis, unwrapped
  double removed_volume_total = 0.0;               ///< m3, by all parts since the start
  std::span<const double> removed_volume_by_part;  ///< m3, in this step
  std::span<const double> cone_angles;             ///< rad, about the cones' Z since the start
  std::span<const double> cone_speeds;             ///< rad/s, in this step
  std::span<const rock::Section> sections;         ///< per cutter, at the end of the step
  std::span<const rock::PartContact> contacts;     ///< per part, at the end of the step
  const DriveRow* drive = nullptr;                 ///< of a bit that forces move
  std::span<const double> nodes;                   ///< append_nodes, of a string on a chain
  const LoadedStep* loaded = nullptr;              ///< forces of the step; none: without forces
  const WearRow* wear = nullptr;                   ///< of a bit that wears
  long swept_vertices = 0;                         ///< rock vertices moved in this step
  long rock_triangles = 0;                         ///< triangles of the rock surface
};

/// A part as the history names it.
struct HistoryPart {
  std::string name;  ///< "cutter-12/face"
  std::string kind;  ///< "face"
};

/// What a history has beside the bit and its parts; empty: nothing of it.
struct HistoryExtent {
  std::vector<std::string> cones;
  std::vector<std::string> cutters;  ///< whose sections are measured
  bool contact_areas = false;
  bool forces = false;
  bool drive = false;
  bool chain = false;                                 ///< of a string on a chain
  std::vector<std::string> nodes;                     ///< node_names of those that have columns
  std::vector<std::string> worn_cutters, worn_parts;  ///< of a bit that wears
};

/// The columns of a step: those of the bit, then what every part removed, then what the run has
/// besides. Each says what a row of many steps has of it.
RecordLayout step_layout(const std::vector<HistoryPart>& parts, const HistoryExtent& extent);

/// The numbers of a step, in the order of its columns, in place of those in `numbers`.
void numbers_of(const HistoryRow& step, const HistoryExtent& extent, std::vector<double>& numbers);

}  // namespace tdbd::simulation
