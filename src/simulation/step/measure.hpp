#pragma once

#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "rock/section/contact_area.hpp"
#include "rock/section/engaged_ends.hpp"
#include "rock/section/rubbing_contact.hpp"
#include "rock/section/section.hpp"
#include "simulation/case/plans.hpp"
#include "simulation/step/face_paths.hpp"
#include "simulation/step/move.hpp"
#include "simulation/step/spread.hpp"

namespace tdbd::simulation {

/// The cutters' faces, prepared once for their sections; none: not measured.
struct MeasuredFaces {
  std::vector<rock::SectionFace> faces;  ///< per cutter
  std::vector<int> near_lists;           ///< per cutter: rock::SectionPlace::near_list
  std::vector<std::uint8_t> cuts;  ///< per cutter: its face cuts; of others no section is taken
};

/// A cutter's parts are a group, whose list of near vertices covers what is ahead of its face, too.
MeasuredFaces measured_faces(const bit::Bit& bit, const rock::CuttingBit& cutting,
                             const MeasurePlan& plan, FlatMeasure flat);

/// Whether the flat behind the engaged edge is the contact of this part's flat (FlatMeasure::edge): of
/// the body of a worn cutter.
bool bears_on_measured_flat(const ForcePlan& plan, const bit::Bit& bit, const bit::Part& part);

/// How the contact of each part is measured: by whole triangles, which cost less, if the section
/// ahead of a face gives the part's force (faces, and chamfers under ChamferMeasure::edge); clipped
/// otherwise.
std::vector<rock::ContactOfPart> contacts_of(const bit::Bit& bit, const ForcePlan& plan);

/// The parts that rub and have a law, prepared once for their contacts.
std::vector<rock::RubbingPart> rubbing_parts(const bit::Bit& bit, const ForcePlan& plan,
                                             double cell);

/// How far the lists of vertices near the bit must reach for these measures.
rock::NearListMargins list_margins_for(const MeasurePlan& plan, double edge_length);

/// What a step is measured on.
struct MeasuredStep {
  const bit::Bit& bit;
  const rock::CuttingBit& cutting;
  const rock::CutWorkspace& cut_work;
  const rock::CutReport& cut;
  const Move& move;
  double edge_length;                               ///< m, of the rock
  long number;                                      ///< of the step: whose turn it is
  const FacePaths& paths;                           ///< of the faces
  std::span<const rock::ContactOfPart> contacts{};  ///< rock::ContactOptions::by_part
};

/// A piece of a part's contact, with a normal and a velocity of its own.
struct PatchOfPart {
  int part = -1;
  rock::ContactPatch patch;
};

/// The measures of one step.
struct Measures {
  /// Per cutter; none: not measured. NaN where the section is refused: the face is deep in rock
  /// (Sight::none), its surface out of sight, or rock reaches over its top (Sight::over_the_top).
  /// In between the turns of a face (MeasurePlan::section_every) its last one.
  std::vector<rock::Section> sections;
  std::vector<std::uint8_t> is_new;         ///< per cutter: the section is of this step
  std::vector<rock::EngagedEnds> ends;      ///< per cutter, of the section; empty: not measured
  std::vector<double> removed;              ///< m3, per cutter, without what broke out beside it
  std::vector<rock::PartContact> contacts;  ///< per part; none: not measured
  std::vector<PatchOfPart> patches;         ///< of the parts that rub, in their order
};

/// Room for them, kept between steps so that none allocates once warm.
struct MeasureWork {
  PerThread<rock::SectionWork> sections;
  rock::ContactWork contact;
};

/// Measures where the bit has come to. To be called between cut_rock and maintenance, once a
/// step: the contact's displacements are updated (rock::contact_areas). A face whose
/// turn it is not keeps the section that stands in `measures`; without any, all are measured.
void measure_cut(rock::Rock& rock, const MeasurePlan& plan, const MeasuredFaces& faces,
                 const MeasuredStep& step, MeasureWork& work, Measures& measures);

/// By step: one cutter's section (m2), what it swept and what the cutter's parts removed (m3).
struct FaceSpreads {
  Spread area, swept, removed;
};

/// The spreads of all sections over revolutions.
struct FaceStatistics {
  std::vector<FaceSpreads> revolution;  ///< per cutter, of the revolution that goes on
  std::vector<FaceSpreads> last_whole;  ///< of the last whole revolution; none yet: empty
  std::size_t revolutions = 0;          ///< begun before the one that goes on
  long refused_deep = 0, refused_over_the_top = 0;  ///< sections (Measures::sections)
};

/// Adds the measures of a step. A section counts once, in the step that measured it; what was
/// removed counts in every step for which a section stands.
void add(const Move& move, const Measures& measures, FaceStatistics& statistics);

/// One cutter's section beside the volume that it removed, over a revolution.
struct FaceFigures {
  std::string name;                    ///< "cutter-12"
  long steps = 0;                      ///< measured; with none, nothing below is known
  double mean_area = 0.0;              ///< m2
  double mean_swept_by_section = 0.0;  ///< m3 in a step
  double mean_removed = 0.0;           ///< m3 in a step
  double rms_swept_by_section = 0.0;   ///< over the mean
  double rms_removed = 0.0;            ///< over the mean
};

/// Of the last whole revolution; before its end, of all steps.
std::vector<FaceFigures> figures_of(const bit::Bit& bit, const FaceStatistics& statistics);

/// The cutter's name, as its parts have it.
std::string cutter_name(const bit::Cutter& cutter);

}  // namespace tdbd::simulation
