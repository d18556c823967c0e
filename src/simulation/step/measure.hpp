#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "rock/section/contact_area.hpp"
#include "rock/section/section.hpp"
#include "simulation/case/measure_plan.hpp"
#include "simulation/step/spread.hpp"

namespace tdbd::simulation {

/// By step: one cutter's section (m2), what it swept and what the cutter's parts removed (m3).
struct FaceSpreads {
  Spread area, swept, removed;
};

/// One cutter's section beside the volume that it removed, over a revolution.
struct FaceFigures {
  std::string name;                    ///< "cutter-12"
  double mean_area = 0.0;              ///< m2
  double mean_swept_by_section = 0.0;  ///< m3 in a step
  double mean_removed = 0.0;           ///< m3 in a step
  double rms_swept_by_section = 0.0;   ///< over the mean
  double rms_removed = 0.0;            ///< over the mean
};

/// The measures of the last step, and their spreads over revolutions.
struct Measures {
  std::vector<rock::Section> sections;      ///< per cutter; none: not measured
  std::vector<rock::PartContact> contacts;  ///< per part; none: not measured
  std::vector<FaceSpreads> revolution;      ///< per cutter, of the revolution that goes on
  std::vector<FaceSpreads> last_whole;      ///< of the last whole revolution; none yet: empty
  std::size_t revolutions = 0;              ///< begun before the one that goes on
  long refused_deep = 0;          ///< sections: the face is deep in rock, its surface out of sight
  long refused_over_the_top = 0;  ///< sections: rock reaches over the face's top
  std::vector<rock::SectionFace> faces;
  std::vector<int> near_list_of_face;  ///< rock::SectionPlace::near_list
  std::vector<double> removed;         ///< m3, per cutter, in the last step
  rock::SectionWork section_work;
  rock::ContactWork contact_work;
};

Measures start_measures(const bit::Bit& bit, const MeasurePlan& plan);

/// How far the lists of vertices near the bit must reach for these measures.
rock::NearListMargins foresight_of(const MeasurePlan& plan, double edge_length);

/// What is measured where the bit has come to in a step from pose 0 to pose 1.
struct MeasuredStep {
  const bit::Bit& bit;
  const rock::CuttingBit& cutting;
  const rock::CutWorkspace& cut_work;
  const rock::CutReport& cut;
  Pose X_WB0, X_WB1;
  double dt = 0.0;             ///< s
  double edge_length = 0.0;    ///< m, of the rock
  std::size_t revolution = 0;  ///< that the step is in, from 0
};

/// To be asked between cut_rock and maintenance.
void measure(const rock::Rock& rock, const MeasurePlan& plan, const MeasuredStep& step,
             Measures& measures);

/// Of the last whole revolution; before its end, of all steps.
std::vector<FaceFigures> figures_of(const bit::Bit& bit, const Measures& measures);

/// The cutter's name, as its parts have it.
std::string cutter_name(const bit::Cutter& cutter);

}  // namespace tdbd::simulation
