#pragma once

#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/types.hpp"
#include "rock/section/column_sums.hpp"
#include "rock/section/contact_area.hpp"
#include "rock/section/rubbing_contact.hpp"
#include "rock/section/section.hpp"
#include "rotation/screw.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::simulation {

/// Running mean of a number over steps, and the sum of its squared deviations from the mean
/// (Welford's algorithm).
struct RunningVariance {
  long count = 0;
  double mean = 0.0, squares = 0.0;

  template <class Archive>
  void serialize(Archive& a) {
    a(count, mean, squares);
  }
};

void add(RunningVariance& spread, double x);

/// Standard deviation (divisor n); 0 without samples.
double deviation(const RunningVariance& spread);

/// Standard deviation divided by the mean; 0 if the mean is 0.
double relative_deviation(const RunningVariance& spread);

/// Motion of the bit in a step, from pose 0 to pose 1 relative to the rock.
struct Move {
  Pose X_WB0, X_WB1;
  double dt = 0.0;             ///< s
  double turn = 0.0;           ///< rad about the axis of the bit
  std::size_t revolution = 0;  ///< revolution of the step, from 0
};

/// Velocity of the bit relative to the rock. Frame W.
struct BitVelocity {
  Vec3 p_WB = Vec3::Zero();         ///< m, origin of the bit
  Vec3 v_W = Vec3::Zero();          ///< m/s, velocity of that origin
  Vec3 w_W = Vec3::Zero();          ///< rad/s
  std::vector<double> cone_speeds;  ///< rad/s, phi' about the Z axes of the cones
};

/// Velocity at the end of the screw motion of the step, with these speeds of the cones.
BitVelocity velocity_of(const Move& move, std::vector<double> cone_speeds);

/// Velocity of the point x_W of the bit, m/s, which belongs to this cone (-1: to the body).
Vec3 velocity_at(const bit::Bit& bit, const Pose& X_WB, const BitVelocity& motion, int cone,
                 const Vec3& x_W);

/// Path along which the section ahead of a face is taken. The direction in which a bit at rest
/// creeps is noise: faces would alternate between thousands of mm2 and nothing ahead of them. A
/// creeping face is therefore measured along its last path, which is initially a rotation about the
/// axis of the bit, and keeps its last section if there is no rock surface ahead. An addition of
/// TDBD [+].
struct FacePath {
  rotation::Twist way{Vec3::UnitZ(), Vec3::Zero()};  ///< in B, with the speed of the face
  bool creeps = false;

  template <class Archive>
  void serialize(Archive& a) {
    a(way, creeps);
  }
};

/// One entry per cutter. If empty, all faces use the path of the step.
using FacePaths = std::vector<FacePath>;

/// Slip speed of the law of each cutter's face, m/s; 0 if there is none.
std::vector<double> creep_speeds(const bit::Bit& bit, const ForcePlan& plan);

/// Stores the path of the step for all faces that do not creep, that is, that move forward faster
/// than `creep` (m/s, per cutter), or ten times as fast in any direction.
void follow(const bit::Bit& bit, const Move& move, std::span<const double> creep, FacePaths& paths);

inline bool creeps(const FacePaths& paths, int cutter) {
  return !paths.empty() && paths[at(cutter)].creeps;
}

/// The path along which a face is measured, with the speed of the step.
rotation::Twist path_of(const FacePaths& paths, const bit::Bit& bit, int cutter,
                        const rotation::Twist& of_step);

/// The faces of the cutters, prepared once for their sections. Empty if not measured.
struct MeasuredFaces {
  std::vector<rock::SectionFace> faces;  ///< per cutter
  std::vector<int> near_lists;           ///< per cutter: see rock::SectionPlace::near_list
  std::vector<std::uint8_t> cuts;        ///< per cutter: whether its face cuts; if not, no section
};

/// Prepares the faces. The parts of a cutter are a group, whose list of near vertices also covers
/// the region ahead of its face.
MeasuredFaces prepare_measured_faces(const bit::Bit& bit, const rock::CuttingBit& cutting,
                                     const MeasurePlan& plan, FlatMeasure flat);

/// Whether the contact of this part's flat is measured behind the engaged edge (FlatMeasure::edge).
/// True for the body of a worn cutter.
bool has_measured_flat(const ForcePlan& plan, const bit::Bit& bit, const bit::Part& part);

/// How the contact of each part is measured. If the force on the part is computed from the section
/// ahead of a face (faces, and chamfers with ChamferMeasure::edge), whole triangles are used, which
/// is faster; otherwise they are clipped.
std::vector<rock::ContactOfPart> contacts_of(const bit::Bit& bit, const ForcePlan& plan);

/// The rubbing parts that have a law, prepared once for their contacts.
std::vector<rock::RubbingPart> rubbing_parts(const bit::Bit& bit, const ForcePlan& plan,
                                             double cell);

/// Margins of the lists of vertices near the bit that these measurements require.
rock::NearListMargins list_margins_for(const MeasurePlan& plan, double edge_length);

/// Inputs of the measurements of a step.
struct MeasuredStep {
  const bit::Bit& bit;
  const rock::CuttingBit& cutting;
  const rock::CutWorkspace& cut_work;
  const rock::CutReport& cut;
  const Move& move;
  double edge_length;                               ///< m, edge length of the rock
  long number;                                      ///< number of the step
  const FacePaths& paths;                           ///< of the faces
  std::span<const rock::ContactOfPart> contacts{};  ///< rock::ContactOptions::by_part
};

/// A patch of a part's contact with its own normal and velocity.
struct PatchOfPart {
  int part = -1;
  rock::ContactPatch patch;
};

/// Measurements of one step.
struct Measures {
  /// Per cutter; empty if not measured. NaN if the section is rejected, because the face is deep in
  /// rock and finds no rock surface (OutlineStatus::none), or because rock extends over its top
  /// (OutlineStatus::over_the_top). Between its turns (MeasurePlan::section_every) a face keeps its last
  /// section.
  std::vector<rock::Section> sections;
  std::vector<std::uint8_t> is_new;         ///< per cutter: section taken in this step
  std::vector<rock::EngagedEnds> ends;      ///< per cutter, of the section; empty if not measured
  std::vector<double> removed;              ///< m3, per cutter, without the volume that broke out
  std::vector<rock::PartContact> contacts;  ///< per part; empty if not measured
  std::vector<PatchOfPart> patches;         ///< of the rubbing parts, in their order
};

/// Work data, reused so that later steps allocate nothing.
struct MeasureWork {
  PerThread<rock::SectionWork> sections;
  rock::ContactWork contact;
};

/// Measures sections and contacts at the end of the step. Must be called once per step, between
/// cut_rock and maintenance, because it updates the displacements of contacts
/// (rock::contact_areas). A face whose turn it is not keeps its section in `measures`; if there are
/// no sections yet, all faces are measured.
void measure_cut(rock::Rock& rock, const MeasurePlan& plan, const MeasuredFaces& faces,
                 const MeasuredStep& step, MeasureWork& work, Measures& measures);

/// Statistics over steps for one cutter: area of the section (m2), volume that it swept and volume
/// removed by the parts of the cutter (m3).
struct FaceVariances {
  RunningVariance area, swept, removed;

  template <class Archive>
  void serialize(Archive& a) {
    a(area, swept, removed);
  }
};

/// Statistics of all sections by revolution.
struct FaceStatistics {
  std::vector<FaceVariances> revolution;  ///< per cutter, current revolution
  std::vector<FaceVariances> last_whole;  ///< last complete revolution; empty before its end
  std::size_t revolutions = 0;            ///< started before the current one
  long refused_deep = 0, refused_over_the_top = 0;  ///< rejected sections (Measures::sections)

  template <class Archive>
  void serialize(Archive& a) {
    a(revolution, last_whole, revolutions, refused_deep, refused_over_the_top);
  }
};

/// Adds the measurements of a step. A section is counted once, in the step in which it was taken;
/// removed volumes are counted in every step with a valid section.
void add(const Move& move, const Measures& measures, FaceStatistics& statistics);

/// Comparison of a cutter's section with the volume that it removed, over a revolution.
struct FaceSummary {
  std::string name;                    ///< "cutter-12"
  long steps = 0;                      ///< measured steps; if 0, the others are unknown
  double mean_area = 0.0;              ///< m2
  double mean_swept_by_section = 0.0;  ///< m3 per step
  double mean_removed = 0.0;           ///< m3 per step
  double rms_swept_by_section = 0.0;   ///< relative to the mean
  double rms_removed = 0.0;            ///< relative to the mean
};

/// Statistics of the last complete revolution; before its end, of all steps.
std::vector<FaceSummary> summarize(const bit::Bit& bit, const FaceStatistics& statistics);

/// The name of the cutter as used in the names of its parts.
std::string cutter_name(const bit::Cutter& cutter);

}  // namespace tdbd::simulation
