#include "simulation/step/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bit/cutter/cutter.hpp"
#include "forces/part/directions.hpp"

namespace tdbd::simulation {
namespace {

/// Takes area and position of the part of a face in rock from its section.
void take_section(const rock::Section& s, const Pose& X_WB, CutOfPart& c) {
  c.face_area = s.area;
  c.cut.point = X_WB * s.centroid_B;
  c.cut.engaged_edge = s.engaged_edge;
}

/// Measure of the thesis [R]: the volume removed by the whole cutter, divided by the displacement
/// of its tip along X. The whole cutter is used because the part that captures a vertex depends on
/// the mesh.
void take_volume(const bit::Cutter& cutter, double removed, const MeasuredStep& step,
                 CutOfPart& c) {
  const rotation::Twist twist =
      rotation::twist_from(step.move.X_WB0, step.move.X_WB1, step.move.dt);
  const Vec3 tip_B = bit::tip_B(cutter);
  const double ahead = cutter.X_BC.R.col(0).dot(rotation::velocity_B(twist, tip_B)) * step.move.dt;
  c.face_area = ahead > 0.0 ? std::max(0.0, removed) / ahead : 0.0;
  if (c.cut.engaged_edge == 0.0) c.cut.point = step.move.X_WB1 * tip_B;
}

void take_face(const ForcePlan& plan, const MeasuredStep& step, const Measures& m, CutOfPart& c) {
  const bit::Cutter& cutter = step.bit.cutters[at(step.bit.parts[at(c.part)].cutter)];
  c.cut.diameter = cutter.diameter;
  c.cut.normal = step.move.X_WB1.R * bit::profile_normal_B(cutter);
  c.forward_W = step.move.X_WB1.R * cutter.X_BC.R.col(0);
  const rock::Section& s = m.sections[at(step.bit.parts[at(c.part)].cutter)];
  if (std::isnan(s.area)) return;  // rejected section: the rock ahead is unknown
  take_section(s, step.move.X_WB1, c);
  if (plan.cut == CutMeasure::volume)
    take_volume(cutter, m.removed[at(step.bit.parts[at(c.part)].cutter)], step, c);
}

/// Takes the engaged edge of the face of the cutter, if the section has one.
void take_edge(const MeasuredStep& step, const Measures& m, CutOfPart& c) {
  const int cutter = step.bit.parts[at(c.part)].cutter;
  const rock::Section& s = m.sections[at(cutter)];
  c.cut.normal = step.move.X_WB1.R * bit::profile_normal_B(step.bit.cutters[at(cutter)]);
  if (!(s.engaged_edge > 0.0)) return;
  constexpr double right_angle = 0.5 * std::numbers::pi;
  c.cut.contact_area =
      s.engaged_edge * chamfer_width(step.bit.cutters[at(cutter)], right_angle - s.angle_of_attack);
  c.cut.engaged_edge = s.engaged_edge;
  c.cut.point = step.move.X_WB1 * s.edge_centroid_B;
}

/// Takes the wear flat of the cutter behind its engaged edge.
void take_flat(const MeasuredStep& step, const Measures& m, CutOfPart& c) {
  const int cutter = step.bit.parts[at(c.part)].cutter;
  const rock::Section& s = m.sections[at(cutter)];
  c.cut.contact_area = s.flat_area > 0.0 ? s.flat_area : 0.0;
  c.cut.normal = step.move.X_WB1.R * bit::profile_normal_B(step.bit.cutters[at(cutter)]);
  c.cut.point = step.move.X_WB1 * s.flat_centroid_B;
  c.distance = 0.0;
}

void take_contact(const rock::ContactPatch& contact, CutOfPart& c) {
  const double sum = contact.area_vector_W.norm();
  if (!(sum > 0.0)) return;
  c.cut.contact_area = sum;
  c.cut.normal = -contact.area_vector_W / sum;
  c.cut.point = contact.centroid_W;
}

void take_part(const ForcePlan& plan, const MeasuredStep& step, const Measures& m, CutOfPart& c) {
  if (c.cut.kind == bit::PartKind::face) return take_face(plan, step, m, c);
  if (c.cut.kind == bit::PartKind::chamfer && plan.chamfer == ChamferMeasure::edge)
    return take_edge(step, m, c);
  if (m.contacts.empty()) return;
  take_contact(rock::whole(m.contacts[at(c.part)]), c);
  c.distance = m.contacts[at(c.part)].distance;
}

/// Adds a patch of the contact of a part as a separate cut. The first patch gets the removed volume
/// of the part.
void add_patch(const ForcePlan& plan, const rock::ContactPatch& patch, double distance,
               CutOfPart& whole, std::vector<CutOfPart>& cuts) {
  CutOfPart c = whole;
  c.cut.contact_area = 0.0;
  c.distance = distance;
  take_contact(patch, c);
  if (!(c.cut.contact_area > 0.0)) return;
  c.cut.strength = forces::strength_at(plan.rock, c.cut.point);
  cuts.push_back(c);
  whole.cut.removed_volume = 0.0;
}

/// Makes the sides of a pressing part a separate contact. They crush rock while the surface below
/// them may only slide, and a common contact would have a single normal. The same applies to crest
/// and flanks of a milled tooth (ContactDivision::by_direction).
void split_contact(const ForcePlan& plan, const MeasuredStep& step, const Measures& m,
                   std::vector<CutOfPart>& cuts) {
  CutOfPart whole = cuts.back();
  if (m.contacts.empty() || !forces::pressing(law_of(plan, whole), whole.cut)) return;
  const rock::PartContact& contact = m.contacts[at(whole.part)];
  const bool is_divided = !step.contacts.empty() && step.contacts[at(whole.part)].division ==
                                                        rock::ContactDivision::by_direction;
  if (!is_divided && !(contact.sides.area > 0.0)) return;
  cuts.pop_back();
  if (is_divided)
    for (const rock::ContactPatch& patch : contact.facing)
      add_patch(plan, patch, whole.distance, whole, cuts);
  else
    add_patch(plan, contact.below, whole.distance, whole, cuts);
  add_patch(plan, contact.sides, 0.0, whole, cuts);
}

/// Replaces the contact of a rubbing part by its patches.
void split_patches(const ForcePlan& plan, const Measures& m, std::vector<CutOfPart>& cuts) {
  CutOfPart whole = cuts.back();
  const auto is_of_part = [&](const PatchOfPart& p) { return p.part == whole.part; };
  if (std::ranges::none_of(m.patches, is_of_part)) return;
  cuts.pop_back();
  for (const PatchOfPart& p : m.patches)
    if (is_of_part(p)) add_patch(plan, p.patch, whole.distance, whole, cuts);
}

/// A flat whose contact is measured by its edge is a separate contact, before those of the rest of
/// its part.
void add_flat(const ForcePlan& plan, const MeasuredStep& step, const Measures& m,
              const CutOfPart& part, std::vector<CutOfPart>& cuts) {
  if (!has_measured_flat(plan, step.bit, step.bit.parts[at(part.part)])) return;
  CutOfPart flat = part;
  flat.cut.removed_volume = 0.0;
  take_flat(step, m, flat);
  if (!(flat.cut.contact_area > 0.0)) return;
  flat.cut.strength = forces::strength_at(plan.rock, flat.cut.point);
  cuts.push_back(flat);
}

}  // namespace

double chamfer_width(const bit::Cutter& c, double back_rake) {
  return bit::chamfer_depth(c) * std::cos(back_rake) + (c.chamfer + c.land) * std::sin(back_rake);
}

void gather_cuts(const ForcePlan& plan, const MeasuredStep& step, const Measures& m,
                 std::vector<CutOfPart>& cuts) {
  cuts.clear();
  for (std::size_t i = 0; i < step.bit.parts.size(); ++i) {
    if (!has_law(plan, step.bit, i)) continue;
    CutOfPart c;
    c.part = static_cast<int>(i);
    c.cone = step.bit.parts[i].cone;
    c.cut.kind = step.bit.parts[i].kind;
    c.cut.removed_volume = step.cut.removed_by_part[i];
    add_flat(plan, step, m, c, cuts);
    take_part(plan, step, m, c);
    if (!(c.face_area > 0.0) && !(c.cut.contact_area > 0.0)) continue;
    c.cut.strength = forces::strength_at(plan.rock, c.cut.point);
    if (!forces::pressing(law_of(plan, c), c.cut)) c.distance = 0.0;
    cuts.push_back(c);
    split_contact(plan, step, m, cuts);
    split_patches(plan, m, cuts);
  }
}

void gather_touching(const ForcePlan& plan, const bit::Bit& bit,
                     const std::vector<rock::PartContact>& contacts, std::vector<CutOfPart>& cuts) {
  cuts.clear();
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    CutOfPart c;
    c.part = static_cast<int>(i);
    c.cone = bit.parts[i].cone;
    c.cut.kind = bit.parts[i].kind;
    take_contact(rock::whole(contacts[i]), c);
    c.cut.strength = forces::strength_at(plan.rock, c.cut.point);
    const auto law = forces::pressing(law_of(plan, c), c.cut);
    if (law && law->limit > 0.0 && law->ramp == 0.0) cuts.push_back(c);
  }
}

forces::PartCut cut_at(const bit::Bit& bit, const Pose& X_WB, const BitVelocity& motion, double dt,
                       const CutOfPart& c) {
  return cut_at_velocity(velocity_at(bit, X_WB, motion, c.cone, c.cut.point), dt, c);
}

forces::PartCut cut_at_velocity(const Vec3& v_W, double dt, const CutOfPart& c) {
  forces::PartCut cut = c.cut;
  cut.velocity = v_W - c.distance / dt * c.cut.normal;
  const double speed = cut.velocity.norm();
  cut.path = speed * dt;
  if (!(c.face_area > 0.0)) return cut;
  const double ahead =
      speed > 0.0 ? std::clamp(c.forward_W.dot(cut.velocity) / speed, 0.0, 1.0) : 1.0;
  cut.cut_area = c.face_area * ahead;
  cut.back_rake = forces::effective_back_rake(c.forward_W, cut.velocity);
  cut.depth = cut.engaged_edge > 0.0 ? cut.cut_area / cut.engaged_edge : 0.0;
  return cut;
}

}  // namespace tdbd::simulation
