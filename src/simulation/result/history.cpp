#include "simulation/result/history.hpp"

#include "simulation/result/history_columns.hpp"

namespace tdbd::simulation {
namespace {

void add_parts(const std::vector<HistoryPart>& parts, RecordLayout& layout) {
  RecordLabels names{"part_name", "name of the part", 0, {}};
  RecordLabels kinds{"part_kind", "kind of the part", 0, {}};
  for (const HistoryPart& p : parts) {
    names.texts.push_back(p.name);
    kinds.texts.push_back(p.kind);
  }
  layout.axes = {{"part", names.texts}};
  layout.columns.push_back(
      {"removed_volume_by_part", "m3", "rock removed by the part in the step", 0, InCsv::no});
  layout.labels = {names, kinds};
}

void add_cones(const std::vector<std::string>& cones, RecordLayout& layout) {
  const int axis = static_cast<int>(layout.axes.size());
  layout.axes.push_back({"cone", cones});
  layout.columns.push_back(
      {"cone_angle", "rad", "angle of the cone about its axis", axis, InCsv::no});
  layout.columns.push_back(
      {"cone_speed", "rad s-1", "speed of the cone about its axis in the step", axis, InCsv::no});
  layout.labels.push_back({"cone_name", "name of the cone", axis, cones});
}

void add_contact_areas(RecordLayout& layout) {
  layout.columns.push_back(
      {"contact_area_total", "m2", "rock surface in contact, summed over the parts"});
  layout.columns.push_back(
      {"contact_area", "m2", "rock surface that the part moved or touches", 0, InCsv::no});
}

void add_sections(const std::vector<std::string>& cutters, RecordLayout& layout) {
  const int axis = static_cast<int>(layout.axes.size());
  layout.axes.push_back({"cutter", cutters});
  for (const SectionColumn& c : section_totals)
    layout.columns.push_back({c.name, c.units, c.long_name});
  for (const SectionColumn& c : section_columns)
    layout.columns.push_back({c.name, c.units, c.long_name, axis, InCsv::no});
  layout.labels.push_back({"cutter_name", "name of the cutter", axis, cutters});
}

void add_loads(RecordLayout& layout) {
  for (const LoadColumn& c : load_columns) layout.columns.push_back({c.name, c.units, c.long_name});
  for (const PartLoadColumn& c : part_load_columns)
    layout.columns.push_back({c.name, c.units, c.long_name, 0, InCsv::no});
}

/// The columns of a row, then what every part removed, then what the run has besides.
RecordLayout layout_for(const std::vector<HistoryPart>& parts, const HistoryExtent& extent) {
  RecordLayout layout;
  for (const HistoryColumn& c : history_columns)
    layout.columns.push_back({c.name, c.units, c.long_name});
  add_parts(parts, layout);
  if (!extent.cones.empty()) add_cones(extent.cones, layout);
  if (extent.contact_areas) add_contact_areas(layout);
  if (!extent.cutters.empty()) add_sections(extent.cutters, layout);
  if (extent.forces) add_loads(layout);
  if (!extent.drive) return layout;
  for (const DriveColumn& c : drive_columns)
    layout.columns.push_back({c.name, c.units, c.long_name});
  return layout;
}

void append_sections(std::span<const rock::Section> sections, std::vector<double>& row) {
  for (const SectionColumn& c : section_totals) {
    double sum = 0.0;
    for (const rock::Section& s : sections) sum += c.value(s);
    row.push_back(sum);
  }
  for (const SectionColumn& c : section_columns)
    for (const rock::Section& s : sections) row.push_back(c.value(s));
}

void append_loads(const LoadedStep& loaded, std::vector<double>& row) {
  for (const LoadColumn& c : load_columns) row.push_back(c.value(loaded));
  for (const PartLoadColumn& c : part_load_columns)
    for (const PartLoad& p : loaded.loads.parts) row.push_back(c.value(p));
}

}  // namespace

History::History(const std::filesystem::path& path, const std::vector<HistoryPart>& parts,
                 const HistoryExtent& extent)
    : extent_(extent), record_(path, layout_for(parts, extent)) {}

void History::append(const HistoryRow& row) {
  row_.clear();
  for (const HistoryColumn& c : history_columns) row_.push_back(c.value(row));
  row_.insert(row_.end(), row.removed_volume_by_part.begin(), row.removed_volume_by_part.end());
  row_.insert(row_.end(), row.cone_angles.begin(), row.cone_angles.end());
  row_.insert(row_.end(), row.cone_speeds.begin(), row.cone_speeds.end());
  if (extent_.contact_areas) {
    const std::size_t total = row_.size();
    row_.push_back(0.0);
    for (const rock::PartContact& c : row.contacts) {
      row_[total] += c.area;
      row_.push_back(c.area);
    }
  }
  if (!extent_.cutters.empty()) append_sections(row.sections, row_);
  if (extent_.forces && row.loaded != nullptr) append_loads(*row.loaded, row_);
  if (extent_.drive && row.drive != nullptr)
    for (const DriveColumn& c : drive_columns) row_.push_back(c.value(*row.drive));
  record_.append(row_);
}

void History::close() { record_.close(); }

}  // namespace tdbd::simulation
