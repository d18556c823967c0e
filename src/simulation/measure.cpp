#include "simulation/measure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace tdbd::simulation {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr int rim_points = 64;  // a circle's area to 0.2 %

/// Of rock::SectionPlace, over the edge length: no result changes if it is doubled.
constexpr double reach = 1.0;

void measure_sections(const rock::Rock& rock, const MeasurePlan& plan, const MeasuredStep& step,
                      Measures& m) {
  const rock::Twist twist = rock::twist_from(step.X_WB0, step.X_WB1, step.dt);
  const rock::SectionPlace place{plan.section_lead * step.edge_length, reach * step.edge_length};
  for (std::size_t i = 0; i < m.faces.size(); ++i) {
    m.sections[i] = rock::section(rock, m.faces[i], step.X_WB1, twist, place, m.section_work);
    add(m.revolution[i].swept, m.sections[i].volume_rate * step.dt);
  }
}

void note_removed(const MeasuredStep& step, Measures& m) {
  m.removed.assign(m.faces.size(), 0.0);
  for (std::size_t p = 0; p < step.bit.parts.size(); ++p)
    if (const int cutter = step.bit.parts[p].cutter; cutter >= 0)
      m.removed[at(cutter)] += step.cut.removed_by_part[p];
  for (std::size_t i = 0; i < m.faces.size(); ++i) add(m.revolution[i].removed, m.removed[i]);
}

void turn_revolution(std::size_t revolution, Measures& m) {
  if (revolution == m.revolutions) return;
  m.last_whole.swap(m.revolution);
  m.revolution.assign(m.faces.size(), {});
  m.revolutions = revolution;
}

}  // namespace

void add(Spread& s, double x) {
  ++s.count;
  const double before = x - s.mean;
  s.mean += before / static_cast<double>(s.count);
  s.squares += before * (x - s.mean);
}

double relative_rms(const Spread& s) {
  if (s.count == 0 || s.mean == 0.0) return 0.0;
  return std::sqrt(s.squares / static_cast<double>(s.count)) / s.mean;
}

Measures start_measures(const bit::Bit& bit, const MeasurePlan& plan) {
  Measures m;
  if (plan.section == SectionMeasure::off) return m;
  m.faces.reserve(bit.cutters.size());
  for (const bit::Cutter& c : bit.cutters)
    m.faces.push_back(rock::section_face(rock::face_outline(c, rim_points)));
  m.sections.resize(m.faces.size());
  m.revolution.resize(m.faces.size());
  return m;
}

void measure(const rock::Rock& rock, const MeasurePlan& plan, const MeasuredStep& step,
             Measures& m) {
  if (plan.contact == ContactMeasure::on)
    rock::contact_areas(rock, step.cutting, step.cut_work, plan.contact_gap * step.edge_length,
                        m.contact_work, m.contact_areas);
  if (m.faces.empty()) return;
  turn_revolution(step.revolution, m);
  measure_sections(rock, plan, step, m);
  note_removed(step, m);
}

std::vector<FaceFigures> figures_of(const bit::Bit& bit, const Measures& m) {
  const std::vector<FaceSpreads>& spreads = m.last_whole.empty() ? m.revolution : m.last_whole;
  std::vector<FaceFigures> figures;
  figures.reserve(spreads.size());
  for (std::size_t i = 0; i < spreads.size(); ++i)
    figures.push_back({cutter_name(bit.cutters[i]), spreads[i].swept.mean, spreads[i].removed.mean,
                       relative_rms(spreads[i].swept), relative_rms(spreads[i].removed)});
  return figures;
}

std::string cutter_name(const bit::Cutter& cutter) { return fmt::format("cutter-{}", cutter.id); }

}  // namespace tdbd::simulation
