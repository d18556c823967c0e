#include "simulation/step/measure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "bit/cutter/cutter.hpp"

namespace tdbd::simulation {

void add(RunningVariance& s, double x) {
  ++s.count;
  const double before = x - s.mean;
  s.mean += before / static_cast<double>(s.count);
  s.squares += before * (x - s.mean);
}

double deviation(const RunningVariance& s) {
  return s.count > 0 ? std::sqrt(s.squares / static_cast<double>(s.count)) : 0.0;
}

double relative_deviation(const RunningVariance& s) {
  return s.mean != 0.0 ? deviation(s) / s.mean : 0.0;
}

BitVelocity velocity_of(const Move& move, std::vector<double> cone_speeds) {
  const rotation::Twist twist = rotation::twist_from(move.X_WB0, move.X_WB1, move.dt);
  const Mat3& R_WB = move.X_WB1.R;
  return {move.X_WB1.p, R_WB * twist.linear_B, R_WB * twist.angular_B, std::move(cone_speeds)};
}

Vec3 velocity_at(const bit::Bit& bit, const Pose& X_WB, const BitVelocity& m, int cone,
                 const Vec3& x_W) {
  Vec3 v_W = m.v_W + m.w_W.cross(x_W - m.p_WB);
  if (cone < 0) return v_W;
  const Pose X_WK = X_WB * bit.cones[at(cone)].X_BK;
  return v_W + m.cone_speeds[at(cone)] * X_WK.R.col(2).cross(x_W - X_WK.p);
}

namespace {

double tip_speed(const bit::Cutter& cutter, const rotation::Twist& path) {
  return rotation::velocity_B(path, bit::tip_B(cutter)).norm();
}

/// Whether the face moves forward faster than it would creep, or much faster in any direction.
bool does_not_creep(const bit::Cutter& cutter, const rotation::Twist& path, double creep) {
  constexpr double much = 10.0;
  const Vec3 v_B = rotation::velocity_B(path, bit::tip_B(cutter));
  return cutter.X_BC.R.col(0).dot(v_B) > creep || v_B.norm() > much * creep;
}

double slip_speed_of(const forces::Law& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.slip_speed; }) return l.slip_speed;
        return 0.0;
      },
      law);
}

}  // namespace

std::vector<double> creep_speeds(const bit::Bit& bit, const ForcePlan& plan) {
  const double usual =
      plan.forces == Forces::off ? 0.0 : slip_speed_of(law_of(plan, bit::PartKind::face));
  std::vector<double> creep(bit.cutters.size(), usual);
  if (plan.forces == Forces::off) return creep;
  for (std::size_t p = 0; p < bit.parts.size(); ++p)
    if (const bit::Part& part = bit.parts[p]; part.kind == bit::PartKind::face && part.cutter >= 0)
      creep[at(part.cutter)] = slip_speed_of(law_of(plan, part.kind, static_cast<int>(p)));
  return creep;
}

void follow(const bit::Bit& bit, const Move& move, std::span<const double> creep,
            FacePaths& paths) {
  const rotation::Twist now = rotation::twist_from(move.X_WB0, move.X_WB1, move.dt);
  if (paths.size() != bit.cutters.size()) paths.assign(bit.cutters.size(), {});
  for (std::size_t i = 0; i < paths.size(); ++i) {
    paths[i].creeps = !does_not_creep(bit.cutters[i], now, creep[i]);
    if (!paths[i].creeps) paths[i].way = now;
  }
}

rotation::Twist path_of(const FacePaths& paths, const bit::Bit& bit, int cutter,
                        const rotation::Twist& of_step) {
  if (!creeps(paths, cutter)) return of_step;
  rotation::Twist path = paths[at(cutter)].way;
  const double then = tip_speed(bit.cutters[at(cutter)], path);
  if (!(then > 0.0)) return of_step;
  const double slower = tip_speed(bit.cutters[at(cutter)], of_step) / then;
  path.angular_B *= slower;
  path.linear_B *= slower;
  return path;
}

namespace {

/// For rock::SectionPlace, in edge lengths. Results do not change if it is doubled.
constexpr double section_reach = 1.0;

rotation::Twist twist_of(const Move& move) {
  return rotation::twist_from(move.X_WB0, move.X_WB1, move.dt);
}

rock::EngagedEnds ends_of(const rock::Section& s, const rock::SectionWork& work) {
  if (s.sight != rock::OutlineStatus::clear || work.measured == nullptr) return {};
  return rock::engaged_ends(*work.measured, work.sums);
}

/// Sections depend only on the rock, so the faces are measured in parallel.
void measure_sections(const rock::Rock& rock, const MeasurePlan& plan, const MeasuredFaces& faces,
                      const MeasuredStep& step, PerThread<rock::SectionWork>& scratches,
                      Measures& m) {
  const rotation::Twist twist = twist_of(step.move);
  const bool are_all_due = m.sections.size() != faces.faces.size();
  m.sections.resize(faces.faces.size());
  m.is_new.assign(faces.faces.size(), 0);
  parallel_for(static_cast<int>(faces.faces.size()), [&](int face) {
    if (!are_all_due && (face + step.number) % plan.section_every != 0) return;
    const std::size_t i = at(face);
    if (faces.cuts[i] == 0) return;
    const rock::SectionPlace place{.lead = plan.section_lead * step.edge_length,
                                   .reach = section_reach * step.edge_length,
                                   .near_list = faces.near_lists[i],
                                   .at_face = plan.section_at_face};
    const rock::Section found =
        rock::section(rock, faces.faces[i], step.move.X_WB1,
                      path_of(step.paths, step.bit, face, twist), place, scratches.local());
    if (!are_all_due && creeps(step.paths, face) && found.sight != rock::OutlineStatus::clear)
      return;
    m.is_new[i] = 1;
    m.sections[i] = found;
    if (!m.ends.empty()) m.ends[i] = ends_of(found, scratches.local());
  });
}

void sum_removed(const MeasuredStep& step, std::size_t cutters, std::vector<double>& removed) {
  removed.assign(cutters, 0.0);
  for (std::size_t p = 0; p < step.bit.parts.size(); ++p)
    if (const int cutter = step.bit.parts[p].cutter; cutter >= 0)
      removed[at(cutter)] += step.cut.removed_by_part[p];
  for (std::size_t p = 0; p < step.cut.broken_out_by_part.size(); ++p)
    if (const int cutter = step.bit.parts[p].cutter; cutter >= 0)
      removed[at(cutter)] -= step.cut.broken_out_by_part[p];
}

/// Whether a face is deep in rock: it finds no rock surface, and removes more than half of the
/// volume that its outline sweeps.
bool is_deep_in_rock(const rock::SectionFace& face, const rock::Section& s, double removed,
                     const rotation::Twist& twist, double dt) {
  if (s.sight != rock::OutlineStatus::none || !(removed > 0.0)) return false;
  const double whole = rock::moments(face.outline.rim_F).area *
                       rock::forward_speed(face.outline.X_BF, twist).at_origin * dt;
  return whole > 0.0 && removed > 0.5 * whole;
}

void refuse(rock::Section& s) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  s = {
      unknown, Vec3::Constant(unknown), unknown, unknown, unknown, s.sight, Vec3::Constant(unknown),
      unknown, Vec3::Constant(unknown)};
}

void reject_unknown_sections(const MeasuredFaces& faces, const MeasuredStep& step, Measures& m) {
  const rotation::Twist twist = twist_of(step.move);
  for (std::size_t i = 0; i < faces.faces.size(); ++i) {
    rock::Section& s = m.sections[i];
    if (m.is_new[i] == 0) continue;
    if (s.sight == rock::OutlineStatus::over_the_top ||
        is_deep_in_rock(faces.faces[i], s, m.removed[i],
                        path_of(step.paths, step.bit, static_cast<int>(i), twist), step.move.dt))
      refuse(s);
  }
}

void begin_revolution(const Move& move, std::size_t cutters, FaceStatistics& s) {
  if (move.revolution == s.revolutions) return;
  s.last_whole.swap(s.revolution);
  s.revolution.assign(cutters, {});
  s.revolutions = move.revolution;
}

/// Whether the force on a part of this kind is computed from the section ahead of a face.
bool has_section(const ForcePlan& plan, bit::PartKind kind) {
  return kind == bit::PartKind::face ||
         (kind == bit::PartKind::chamfer && plan.chamfer == ChamferMeasure::edge);
}

/// Whether a part is a milled tooth, whose flat flanks and flat crest each have one normal.
bool is_milled_tooth(const bit::Bit& bit, const bit::Part& part) {
  return part.kind == bit::PartKind::tooth && part.row >= 0 &&
         bit.cones[at(part.cone)].layout.rows[at(part.row)].shape.kind ==
             bit::ToothKind::milled_chisel;
}

}  // namespace

bool has_measured_flat(const ForcePlan& plan, const bit::Bit& bit, const bit::Part& part) {
  return plan.flat == FlatMeasure::edge && part.kind == bit::PartKind::cutter_body &&
         part.cutter >= 0 && bit.cutters[at(part.cutter)].wear > 0.0;
}

MeasuredFaces prepare_measured_faces(const bit::Bit& bit, const rock::CuttingBit& cutting,
                                     const MeasurePlan& plan, FlatMeasure flat) {
  MeasuredFaces m;
  if (plan.section == SectionMeasure::off) return m;
  m.faces.reserve(bit.cutters.size());
  for (std::size_t i = 0; i < bit.cutters.size(); ++i) {
    const int cutter = static_cast<int>(i);
    m.faces.push_back(rock::section_face(rock::face_outline(bit.cutters[i], cutter, bit.parts)));
    if (flat == FlatMeasure::edge)
      m.faces[i].flat = rock::flat_behind(bit.cutters[i], cutter, m.faces[i].outline, bit.parts);
  }
  m.near_lists.assign(m.faces.size(), -1);
  m.cuts.assign(m.faces.size(), 1);
  for (const bit::Part& part : bit.parts)
    if (part.kind == bit::PartKind::face && part.cutter >= 0)
      m.cuts[at(part.cutter)] = part.cutting == bit::Cutting::cuts;
  for (std::size_t k = 0; k < cutting.groups.size(); ++k)
    if (const int cutter = bit.parts[at(cutting.groups[k].parts.front().part)].cutter; cutter >= 0)
      m.near_lists[at(cutter)] = static_cast<int>(k);
  return m;
}

std::vector<rock::ContactOfPart> contacts_of(const bit::Bit& bit, const ForcePlan& plan) {
  std::vector<rock::ContactOfPart> contacts(bit.parts.size());
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    forces::PartCut cut;
    cut.kind = bit.parts[i].kind;
    if (has_section(plan, cut.kind)) contacts[i].rule = rock::ContactRule::whole_triangles;
    if (has_measured_flat(plan, bit, bit.parts[i])) {
      const bit::Cutter& cutter = bit.cutters[at(bit.parts[i].cutter)];
      contacts[i].excluded_normal_P =
          bit.parts[i].X_BP.R.transpose() * bit::profile_normal_B(cutter);
    }
    if (plan.forces == Forces::off || !has_law(plan, bit, i)) continue;
    const auto law = forces::pressing(law_of(plan, cut.kind, static_cast<int>(i)), cut);
    if (!law) continue;
    contacts[i].ramp = law->ramp;
    if (is_milled_tooth(bit, bit.parts[i]))
      contacts[i].division = rock::ContactDivision::by_direction;
  }
  return contacts;
}

std::vector<rock::RubbingPart> rubbing_parts(const bit::Bit& bit, const ForcePlan& plan,
                                             double cell) {
  std::vector<rock::RubbingPart> parts;
  for (std::size_t i = 0; i < bit.parts.size(); ++i)
    if (bit.parts[i].cutting == bit::Cutting::rubs && plan.forces == Forces::on &&
        has_law(plan, bit, i))
      parts.push_back(rock::prepare_rubbing_part(bit.parts[i], static_cast<int>(i), cell));
  return parts;
}

rock::NearListMargins list_margins_for(const MeasurePlan& plan, double edge_length) {
  if (plan.section == SectionMeasure::off) return {};
  constexpr double strip = 1.5;  // lead of a strip of a face relative to the smallest (face_strips)
  const double leads = plan.section_at_face == rock::SectionAtFace::extrapolated ? 2.0 : 1.0;
  return {section_reach * edge_length,
          (strip * leads * plan.section_lead + section_reach) * edge_length};
}

void measure_cut(rock::Rock& rock, const MeasurePlan& plan, const MeasuredFaces& faces,
                 const MeasuredStep& step, MeasureWork& work, Measures& m) {
  if (plan.contact == ContactMeasure::on)
    rock::contact_areas(rock, step.cutting, step.cut_work,
                        {plan.contact_gap * step.edge_length, step.contacts}, work.contact,
                        m.contacts);
  if (faces.faces.empty() || plan.section == SectionMeasure::off) return m.sections.clear();
  measure_sections(rock, plan, faces, step, work.sections, m);
  sum_removed(step, faces.faces.size(), m.removed);
  reject_unknown_sections(faces, step, m);
}

void add(const Move& move, const Measures& m, FaceStatistics& statistics) {
  if (m.sections.empty()) return;
  begin_revolution(move, m.sections.size(), statistics);
  for (std::size_t i = 0; i < m.sections.size(); ++i) {
    const rock::Section& s = m.sections[i];
    const bool is_refused = std::isnan(s.area);
    if (is_refused && m.is_new[i] != 0)
      ++(s.sight == rock::OutlineStatus::over_the_top ? statistics.refused_over_the_top
                                                      : statistics.refused_deep);
    if (is_refused) continue;
    FaceVariances& spreads = statistics.revolution[i];
    add(spreads.removed, m.removed[i]);
    if (m.is_new[i] == 0) continue;
    add(spreads.area, s.area);
    add(spreads.swept, s.volume_rate * move.dt);
  }
}

std::vector<FaceSummary> summarize(const bit::Bit& bit, const FaceStatistics& s) {
  const std::vector<FaceVariances>& spreads = s.last_whole.empty() ? s.revolution : s.last_whole;
  std::vector<FaceSummary> figures;
  figures.reserve(spreads.size());
  for (std::size_t i = 0; i < spreads.size(); ++i)
    figures.push_back({cutter_name(bit.cutters[i]), spreads[i].area.count, spreads[i].area.mean,
                       spreads[i].swept.mean, spreads[i].removed.mean,
                       relative_deviation(spreads[i].swept),
                       relative_deviation(spreads[i].removed)});
  return figures;
}

std::string cutter_name(const bit::Cutter& cutter) { return fmt::format("cutter-{}", cutter.id); }

}  // namespace tdbd::simulation
