#include "simulation/history.hpp"

#include "simulation/history_columns.hpp"

namespace tdbd::simulation {
namespace {

/// The columns of a row, then what every part removed, which the csv leaves out.
RecordLayout layout_for(const std::vector<HistoryPart>& parts,
                        const std::vector<std::string>& cones) {
  RecordLayout layout;
  RecordLabels names{"part_name", "name of the part", 0, {}};
  RecordLabels kinds{"part_kind", "kind of the part", 0, {}};
  for (const HistoryPart& p : parts) {
    names.texts.push_back(p.name);
    kinds.texts.push_back(p.kind);
  }
  layout.axes = {{"part", names.texts}};
  for (const HistoryColumn& c : history_columns)
    layout.columns.push_back({c.name, c.units, c.long_name});
  layout.columns.push_back(
      {"removed_volume_by_part", "m3", "rock removed by the part in the step", 0, InCsv::no});
  layout.labels = {names, kinds};
  if (cones.empty()) return layout;
  layout.axes.push_back({"cone", cones});
  layout.columns.push_back({"cone_angle", "rad", "angle of the cone about its axis", 1, InCsv::no});
  layout.columns.push_back(
      {"cone_speed", "rad s-1", "speed of the cone about its axis in the step", 1, InCsv::no});
  layout.labels.push_back({"cone_name", "name of the cone", 1, cones});
  return layout;
}

}  // namespace

History::History(const std::filesystem::path& path, const std::vector<HistoryPart>& parts,
                 const std::vector<std::string>& cones)
    : record_(path, layout_for(parts, cones)) {}

void History::append(const HistoryRow& row) {
  row_.clear();
  for (const HistoryColumn& c : history_columns) row_.push_back(c.value(row));
  row_.insert(row_.end(), row.removed_volume_by_part.begin(), row.removed_volume_by_part.end());
  row_.insert(row_.end(), row.cone_angles.begin(), row.cone_angles.end());
  row_.insert(row_.end(), row.cone_speeds.begin(), row.cone_speeds.end());
  record_.append(row_);
}

void History::close() { record_.close(); }

}  // namespace tdbd::simulation
