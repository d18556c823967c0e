#include "simulation/step/measure.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace tdbd::simulation {
namespace {

/// Of rock::SectionPlace, over the edge length: no result changes if it is doubled.
constexpr double reach = 1.0;

/// A cutter's parts are a group; its list of near vertices covers what is ahead of its face, too.
void find_near_lists(const MeasuredStep& step, Measures& m) {
  m.near_list_of_face.assign(m.faces.size(), -1);
  for (std::size_t k = 0; k < step.cutting.groups.size(); ++k) {
    const int part = step.cutting.groups[k].parts.front().part;
    if (const int cutter = step.bit.parts[at(part)].cutter; cutter >= 0)
      m.near_list_of_face[at(cutter)] = static_cast<int>(k);
  }
}

void measure_sections(const rock::Rock& rock, const MeasurePlan& plan, const MeasuredStep& step,
                      Measures& m) {
  const rotation::Twist twist = rotation::twist_from(step.X_WB0, step.X_WB1, step.dt);
  rock::SectionPlace place{plan.section_lead * step.edge_length, reach * step.edge_length};
  find_near_lists(step, m);
  for (std::size_t i = 0; i < m.faces.size(); ++i) {
    place.near_list = m.near_list_of_face[i];
    m.sections[i] = rock::section(rock, m.faces[i], step.X_WB1, twist, place, m.section_work);
  }
}

void sum_removed(const MeasuredStep& step, Measures& m) {
  m.removed.assign(m.faces.size(), 0.0);
  for (std::size_t p = 0; p < step.bit.parts.size(); ++p)
    if (const int cutter = step.bit.parts[p].cutter; cutter >= 0)
      m.removed[at(cutter)] += step.cut.removed_by_part[p];
}

/// A face deep in rock, its surface out of sight, removes what its whole outline sweeps.
bool is_deep_in_rock(const rock::SectionFace& face, const rock::Section& s, double removed,
                     const rotation::Twist& twist, double dt) {
  if (s.sight != rock::Sight::none || !(removed > 0.0)) return false;
  const double whole = rock::moments(face.outline.rim_F).area *
                       rock::forward_speed(face.outline.X_BF, twist).at_origin * dt;
  return whole > 0.0 && removed > 0.5 * whole;
}

void refuse(rock::Section& s) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  s = {unknown, Vec3::Constant(unknown), unknown, unknown, unknown,
       s.sight, Vec3::Constant(unknown)};
}

void note(const MeasuredStep& step, Measures& m) {
  const rotation::Twist twist = rotation::twist_from(step.X_WB0, step.X_WB1, step.dt);
  for (std::size_t i = 0; i < m.faces.size(); ++i) {
    rock::Section& s = m.sections[i];
    FaceSpreads& spreads = m.revolution[i];
    const bool deep = is_deep_in_rock(m.faces[i], s, m.removed[i], twist, step.dt);
    if (deep || s.sight == rock::Sight::over_the_top) {
      refuse(s);
      ++(deep ? m.refused_deep : m.refused_over_the_top);
      continue;
    }
    add(spreads.area, s.area);
    add(spreads.swept, s.volume_rate * step.dt);
    add(spreads.removed, m.removed[i]);
  }
}

void turn_revolution(std::size_t revolution, Measures& m) {
  if (revolution == m.revolutions) return;
  m.last_whole.swap(m.revolution);
  m.revolution.assign(m.faces.size(), {});
  m.revolutions = revolution;
}

}  // namespace

Measures start_measures(const bit::Bit& bit, const MeasurePlan& plan) {
  Measures m;
  if (plan.section == SectionMeasure::off) return m;
  m.faces.reserve(bit.cutters.size());
  for (std::size_t i = 0; i < bit.cutters.size(); ++i)
    m.faces.push_back(
        rock::section_face(rock::face_outline(bit.cutters[i], static_cast<int>(i), bit.parts)));
  m.sections.resize(m.faces.size());
  m.revolution.resize(m.faces.size());
  return m;
}

rock::NearListMargins foresight_of(const MeasurePlan& plan, double edge_length) {
  if (plan.section == SectionMeasure::off) return {};
  constexpr double strip = 1.5;  // what a strip of a face comes ahead, over the least (face_strips)
  return {reach * edge_length, (strip * plan.section_lead + reach) * edge_length};
}

void measure(const rock::Rock& rock, const MeasurePlan& plan, const MeasuredStep& step,
             Measures& m) {
  if (plan.contact == ContactMeasure::on)
    rock::contact_areas(rock, step.cutting, step.cut_work, plan.contact_gap * step.edge_length,
                        m.contact_work, m.contacts);
  if (m.faces.empty() || plan.section == SectionMeasure::off) return;
  turn_revolution(step.revolution, m);
  measure_sections(rock, plan, step, m);
  sum_removed(step, m);
  note(step, m);
}

std::vector<FaceFigures> figures_of(const bit::Bit& bit, const Measures& m) {
  const std::vector<FaceSpreads>& spreads = m.last_whole.empty() ? m.revolution : m.last_whole;
  std::vector<FaceFigures> figures;
  figures.reserve(spreads.size());
  for (std::size_t i = 0; i < spreads.size(); ++i)
    figures.push_back({cutter_name(bit.cutters[i]), spreads[i].area.mean, spreads[i].swept.mean,
                       spreads[i].removed.mean, relative_rms(spreads[i].swept),
                       relative_rms(spreads[i].removed)});
  return figures;
}

std::string cutter_name(const bit::Cutter& cutter) { return fmt::format("cutter-{}", cutter.id); }

}  // namespace tdbd::simulation
