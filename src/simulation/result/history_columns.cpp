#include "simulation/result/history_columns.hpp"

#include <array>

#include "simulation/result/chain_record.hpp"

namespace tdbd::simulation {
namespace {

/// One number per row: a variable of `history.nc` and a column of `history.csv`.
template <class Row>
struct ColumnOf {
  const char* name;
  const char* units;  ///< in the syntax of UDUNITS; "1" for counts
  const char* long_name;
  double (*value)(const Row&);
  Over over = Over::point;  ///< in rows of many steps
};

/// Every column of the bit as a whole, in the order of the files. To add a column, add a line.
constexpr std::array history_columns = {
    ColumnOf<HistoryRow>{"time", "s", "time at the end of the step",
                         [](const HistoryRow& r) { return r.time; }},
    ColumnOf<HistoryRow>{"position_x", "m", "origin of the bit in space, x",
                         [](const HistoryRow& r) { return r.p_WB.x(); }},
    ColumnOf<HistoryRow>{"position_y", "m", "origin of the bit in space, y",
                         [](const HistoryRow& r) { return r.p_WB.y(); }},
    ColumnOf<HistoryRow>{"position_z", "m", "origin of the bit in space, z (down)",
                         [](const HistoryRow& r) { return r.p_WB.z(); }},
    ColumnOf<HistoryRow>{"rotation_vector_x", "rad", "attitude of the bit, rotation vector, x",
                         [](const HistoryRow& r) { return r.rotation_vector.x(); }},
    ColumnOf<HistoryRow>{"rotation_vector_y", "rad", "attitude of the bit, rotation vector, y",
                         [](const HistoryRow& r) { return r.rotation_vector.y(); }},
    ColumnOf<HistoryRow>{"rotation_vector_z", "rad", "attitude of the bit, rotation vector, z",
                         [](const HistoryRow& r) { return r.rotation_vector.z(); }},
    ColumnOf<HistoryRow>{"rotation_angle", "rad",
                         "angle turned about the bit's axis since the start",
                         [](const HistoryRow& r) { return r.rotation_angle; }},
    ColumnOf<HistoryRow>{"removed_volume_total", "m3", "rock removed by all parts since the start",
                         [](const HistoryRow& r) { return r.removed_volume_total; }},
    ColumnOf<HistoryRow>{"swept_vertices", "1", "rock vertices moved in the step",
                         [](const HistoryRow& r) { return static_cast<double>(r.swept_vertices); },
                         Over::sum},
    ColumnOf<HistoryRow>{"rock_triangles", "1", "triangles of the rock surface",
                         [](const HistoryRow& r) { return static_cast<double>(r.rock_triangles); }},
};

/// Columns of rock::Section. All values are 0 for a cutter that is not in rock.
constexpr std::array section_columns = {
    ColumnOf<rock::Section>{"section_area", "m2", "uncut rock in the plane of the cutter's face",
                            [](const rock::Section& s) { return s.area; }, Over::mean},
    ColumnOf<rock::Section>{"section_centroid_x", "m",
                            "centroid of the section in the bit's frame, x",
                            [](const rock::Section& s) { return s.centroid_B.x(); }},
    ColumnOf<rock::Section>{"section_centroid_y", "m",
                            "centroid of the section in the bit's frame, y",
                            [](const rock::Section& s) { return s.centroid_B.y(); }},
    ColumnOf<rock::Section>{"section_centroid_z", "m",
                            "centroid of the section in the bit's frame, z",
                            [](const rock::Section& s) { return s.centroid_B.z(); }},
    ColumnOf<rock::Section>{"section_engaged_edge", "m", "length of the cutter's outline in rock",
                            [](const rock::Section& s) { return s.engaged_edge; }, Over::mean},
    ColumnOf<rock::Section>{"section_angle_of_attack", "rad",
                            "angle between face and path, mean along the engaged edge",
                            [](const rock::Section& s) { return s.angle_of_attack; }},
    ColumnOf<rock::Section>{"section_volume_rate", "m3 s-1", "volume that the section sweeps",
                            [](const rock::Section& s) { return s.volume_rate; }, Over::mean},
    ColumnOf<rock::Section>{"section_edge_centroid_x", "m",
                            "centroid of the engaged edge in the bit's frame, x: where the "
                            "force of the chamfer acts",
                            [](const rock::Section& s) { return s.edge_centroid_B.x(); }},
    ColumnOf<rock::Section>{"section_edge_centroid_y", "m",
                            "centroid of the engaged edge in the bit's frame, y: where the "
                            "force of the chamfer acts",
                            [](const rock::Section& s) { return s.edge_centroid_B.y(); }},
    ColumnOf<rock::Section>{"section_edge_centroid_z", "m",
                            "centroid of the engaged edge in the bit's frame, z: where the "
                            "force of the chamfer acts",
                            [](const rock::Section& s) { return s.edge_centroid_B.z(); }},
};

/// Sums over the cutters, which are also written to the csv.
constexpr std::array section_totals = {
    ColumnOf<rock::Section>{"section_area_total", "m2", "sections of all cutters",
                            [](const rock::Section& s) { return s.area; }, Over::mean},
    ColumnOf<rock::Section>{"section_volume_rate_total", "m3 s-1", "volume that all sections sweep",
                            [](const rock::Section& s) { return s.volume_rate; }, Over::mean},
};

/// Loads of the bit. Weight and torque are positive while drilling.
constexpr std::array load_columns = {
    ColumnOf<LoadedStep>{"weight_on_bit", "N", "force of the bit on the rock, z",
                         [](const LoadedStep& s) { return -s.loads.force_W.z(); }},
    ColumnOf<LoadedStep>{"torque_on_bit", "N m",
                         "torque of the bit on the rock about its origin, z",
                         [](const LoadedStep& s) { return -s.loads.torque_W.z(); }},
    ColumnOf<LoadedStep>{"force_x", "N", "force of the rock on the bit in space, x",
                         [](const LoadedStep& s) { return s.loads.force_W.x(); }},
    ColumnOf<LoadedStep>{"force_y", "N", "force of the rock on the bit in space, y",
                         [](const LoadedStep& s) { return s.loads.force_W.y(); }},
    ColumnOf<LoadedStep>{"torque_x", "N m", "torque of the rock on the bit about its origin, x",
                         [](const LoadedStep& s) { return s.loads.torque_W.x(); }},
    ColumnOf<LoadedStep>{"torque_y", "N m", "torque of the rock on the bit about its origin, y",
                         [](const LoadedStep& s) { return s.loads.torque_W.y(); }},
    ColumnOf<LoadedStep>{"drilling_power", "W", "power that the bit spends on the rock",
                         [](const LoadedStep& s) { return s.loads.power; }},
    ColumnOf<LoadedStep>{"velocity_x", "m s-1", "velocity of the bit's origin over the rock, x",
                         [](const LoadedStep& s) { return s.velocity.v_W.x(); }},
    ColumnOf<LoadedStep>{"velocity_y", "m s-1", "velocity of the bit's origin over the rock, y",
                         [](const LoadedStep& s) { return s.velocity.v_W.y(); }},
    ColumnOf<LoadedStep>{"rate_of_penetration", "m s-1",
                         "displacement of the bit's origin over the rock in the step, z, over time",
                         [](const LoadedStep& s) { return s.rates.penetration; }},
    ColumnOf<LoadedStep>{"rotary_speed", "rad s-1",
                         "turn of the bit about its axis in the step, over time",
                         [](const LoadedStep& s) { return s.rates.rotary; }},
};

/// Columns of a bit that forces move.
constexpr std::array drive_columns = {
    ColumnOf<DriveRow>{"rock_position_z", "m", "how far the rock has moved along z",
                       [](const DriveRow& r) { return r.rock_z; }},
    ColumnOf<DriveRow>{"string_twist", "rad", "angle of the string's top over that of the bit",
                       [](const DriveRow& r) { return r.string_twist; }},
    ColumnOf<DriveRow>{"energy_stored", "J", "kinetic and elastic energy of bit, string and rock",
                       [](const DriveRow& r) { return r.stored; }},
    ColumnOf<DriveRow>{"work_of_top", "J", "work of the top since the start",
                       [](const DriveRow& r) { return r.top; }},
    ColumnOf<DriveRow>{"work_on_rock", "J", "work that cutting took from the bit since the start",
                       [](const DriveRow& r) { return r.cutting; }},
    ColumnOf<DriveRow>{"energy_lost", "J", "taken by dampers and by the wall since the start",
                       [](const DriveRow& r) { return r.lost; }},
    ColumnOf<DriveRow>{"energy_residual", "J", "what the ledger of energy does not account for",
                       [](const DriveRow& r) { return r.residual; }},
};

/// Columns of a string on a chain.
constexpr std::array surface_columns = {
    ColumnOf<DriveRow>{"hook_load", "N", "force that holds the string at the surface",
                       [](const DriveRow& r) { return r.hook_load; }},
    ColumnOf<DriveRow>{"surface_torque", "N m", "torque that turns the string at the surface",
                       [](const DriveRow& r) { return r.surface_torque; }},
    ColumnOf<DriveRow>{"top_speed", "rad s-1", "rotary speed of the top of the string",
                       [](const DriveRow& r) { return r.top_speed; }},
    ColumnOf<DriveRow>{"block_speed", "m s-1", "speed of the top of the string, downward",
                       [](const DriveRow& r) { return r.block_speed; }},
};

/// Load of a part: variables over time and part.
constexpr std::array part_load_columns = {
    ColumnOf<PartLoad>{"force_normal", "N", "force of the part along the normal into the rock",
                       [](const PartLoad& p) { return p.normal; }},
    ColumnOf<PartLoad>{"force_tangential", "N", "force of the part along its velocity",
                       [](const PartLoad& p) { return p.tangential; }},
    ColumnOf<PartLoad>{"part_force_x", "N", "force of the rock on the part in space, x",
                       [](const PartLoad& p) { return p.force_W.x(); }},
    ColumnOf<PartLoad>{"part_force_y", "N", "force of the rock on the part in space, y",
                       [](const PartLoad& p) { return p.force_W.y(); }},
    ColumnOf<PartLoad>{"part_force_z", "N", "force of the rock on the part in space, z",
                       [](const PartLoad& p) { return p.force_W.z(); }},
    ColumnOf<PartLoad>{"part_power", "W", "power that the part spends on the rock",
                       [](const PartLoad& p) { return p.power; }},
};

void add_parts(const std::vector<HistoryPart>& parts, RecordLayout& layout) {
  RecordLabels names{"part_name", "name of the part", 0, {}};
  RecordLabels kinds{"part_kind", "kind of the part", 0, {}};
  for (const HistoryPart& p : parts) {
    names.texts.push_back(p.name);
    kinds.texts.push_back(p.kind);
  }
  layout.axes = {{"part", names.texts}};
  layout.columns.push_back({"removed_volume_by_part", "m3", "rock removed by the part in the step",
                            0, InCsv::no, Over::sum});
  layout.labels = {names, kinds};
}

void add_cones(const std::vector<std::string>& cones, RecordLayout& layout) {
  const int axis = static_cast<int>(layout.axes.size());
  layout.axes.push_back({"cone", cones});
  layout.columns.push_back(
      {"cone_angle", "rad", "angle of the cone about its axis", axis, InCsv::no});
  layout.columns.push_back({"cone_speed", "rad s-1", "speed of the cone about its axis in the step",
                            axis, InCsv::no, Over::mean});
  layout.labels.push_back({"cone_name", "name of the cone", axis, cones});
}

void add_contact_areas(RecordLayout& layout) {
  layout.columns.push_back({"contact_area_total", "m2",
                            "rock surface in contact, summed over the parts", -1, InCsv::yes,
                            Over::mean});
  layout.columns.push_back({"contact_area", "m2", "rock surface that the part moved or touches", 0,
                            InCsv::no, Over::mean});
}

void add_sections(const std::vector<std::string>& cutters, RecordLayout& layout) {
  const int axis = static_cast<int>(layout.axes.size());
  layout.axes.push_back({"cutter", cutters});
  for (const ColumnOf<rock::Section>& c : section_totals)
    layout.columns.push_back({c.name, c.units, c.long_name, -1, InCsv::yes, c.over});
  for (const ColumnOf<rock::Section>& c : section_columns)
    layout.columns.push_back({c.name, c.units, c.long_name, axis, InCsv::no, c.over});
  layout.labels.push_back({"cutter_name", "name of the cutter", axis, cutters});
}

void add_loads(RecordLayout& layout) {
  for (const ColumnOf<LoadedStep>& c : load_columns)
    layout.columns.push_back({c.name, c.units, c.long_name, -1, InCsv::yes, Over::mean});
  for (const ColumnOf<PartLoad>& c : part_load_columns)
    layout.columns.push_back({c.name, c.units, c.long_name, 0, InCsv::no, Over::mean});
}

/// Wear of a bit: variables over time and cutter.
constexpr std::array wear_columns = {
    ColumnOf<WearRow>{"flat_width", "m", "width of the cutter's wear flat, across the motion",
                      nullptr},
    ColumnOf<WearRow>{"worn_volume", "m3", "volume that the cutter has lost in the run", nullptr},
    ColumnOf<WearRow>{"flat_temperature", "K", "temperature of the cutter's wear flat", nullptr,
                      Over::mean},
    ColumnOf<WearRow>{"cutter_normal_force", "N", "normal force on all parts of the cutter",
                      nullptr, Over::mean},
};

/// Wear of teeth and gage pads: variables over time and piece.
constexpr std::array worn_part_columns = {
    ColumnOf<WearRow>{"lost_height", "m", "height that the tooth or gage pad has lost in the run",
                      nullptr},
    ColumnOf<WearRow>{"worn_part_volume", "m3", "volume that it has lost in the run", nullptr},
};

void add_worn_parts(const std::vector<std::string>& parts, RecordLayout& layout) {
  const int axis = static_cast<int>(layout.axes.size());
  layout.axes.push_back({"worn_part", parts});
  layout.labels.push_back({"worn_part_name", "name of the tooth or gage pad", axis, parts});
  for (const ColumnOf<WearRow>& c : worn_part_columns)
    layout.columns.push_back({c.name, c.units, c.long_name, axis, InCsv::no, c.over});
}

void add_worn_cutters(const std::vector<std::string>& cutters, RecordLayout& layout) {
  int axis = 0;
  while (at(axis) < layout.axes.size() && layout.axes[at(axis)].name != "cutter") ++axis;
  if (at(axis) == layout.axes.size()) {
    layout.axes.push_back({"cutter", cutters});
    layout.labels.push_back({"cutter_name", "name of the cutter", axis, cutters});
  }
  for (const ColumnOf<WearRow>& c : wear_columns)
    layout.columns.push_back({c.name, c.units, c.long_name, axis, InCsv::no, c.over});
}

void add_wear(const HistoryExtent& extent, RecordLayout& layout) {
  if (extent.worn_cutters.empty() && extent.worn_parts.empty()) return;
  layout.columns.push_back(
      {"wear_distance", "m", "distance that the wear stands for: acceleration times the advance"});
  if (!extent.worn_cutters.empty()) add_worn_cutters(extent.worn_cutters, layout);
  if (!extent.worn_parts.empty()) add_worn_parts(extent.worn_parts, layout);
}

void append_wear(const WearRow& w, std::vector<double>& row) {
  row.push_back(w.distance);
  for (const std::vector<double>* column :
       {&w.width, &w.volume, &w.temperature, &w.force, &w.lost_height, &w.part_volume})
    row.insert(row.end(), column->begin(), column->end());
}

void append_contacts(std::span<const rock::PartContact> contacts, std::vector<double>& row) {
  const std::size_t total = row.size();
  row.push_back(0.0);
  for (const rock::PartContact& c : contacts) {
    const double area = c.below.area + c.sides.area;
    row[total] += area;
    row.push_back(area);
  }
}

void append_sections(std::span<const rock::Section> sections, std::vector<double>& row) {
  for (const ColumnOf<rock::Section>& c : section_totals) {
    double sum = 0.0;
    for (const rock::Section& s : sections) sum += c.value(s);
    row.push_back(sum);
  }
  for (const ColumnOf<rock::Section>& c : section_columns)
    for (const rock::Section& s : sections) row.push_back(c.value(s));
}

void append_loads(const LoadedStep& loaded, std::vector<double>& row) {
  for (const ColumnOf<LoadedStep>& c : load_columns) row.push_back(c.value(loaded));
  for (const ColumnOf<PartLoad>& c : part_load_columns)
    for (const PartLoad& p : loaded.loads.parts) row.push_back(c.value(p));
}

}  // namespace

RecordLayout step_layout(const std::vector<HistoryPart>& parts, const HistoryExtent& extent) {
  RecordLayout layout;
  for (const ColumnOf<HistoryRow>& c : history_columns)
    layout.columns.push_back({c.name, c.units, c.long_name, -1, InCsv::yes, c.over});
  add_parts(parts, layout);
  if (!extent.cones.empty()) add_cones(extent.cones, layout);
  if (extent.contact_areas) add_contact_areas(layout);
  if (!extent.cutters.empty()) add_sections(extent.cutters, layout);
  if (extent.forces) add_loads(layout);
  add_wear(extent, layout);
  if (!extent.drive) return layout;
  for (const ColumnOf<DriveRow>& c : drive_columns)
    layout.columns.push_back({c.name, c.units, c.long_name});
  if (!extent.chain) return layout;
  for (const ColumnOf<DriveRow>& c : surface_columns)
    layout.columns.push_back({c.name, c.units, c.long_name, -1, InCsv::yes, Over::mean});
  if (!extent.nodes.empty()) add_node_columns(extent.nodes, Over::mean, layout);
  return layout;
}

void numbers_of(const HistoryRow& step, const HistoryExtent& extent, std::vector<double>& numbers) {
  numbers.clear();
  for (const ColumnOf<HistoryRow>& c : history_columns) numbers.push_back(c.value(step));
  const auto append = [&](std::span<const double> own) {
    numbers.insert(numbers.end(), own.begin(), own.end());
  };
  append(step.removed_volume_by_part);
  append(step.cone_angles);
  append(step.cone_speeds);
  if (extent.contact_areas) append_contacts(step.contacts, numbers);
  if (!extent.cutters.empty()) append_sections(step.sections, numbers);
  if (extent.forces && step.loaded != nullptr) append_loads(*step.loaded, numbers);
  if (step.wear != nullptr) append_wear(*step.wear, numbers);
  if (!extent.drive || step.drive == nullptr) return;
  for (const ColumnOf<DriveRow>& c : drive_columns) numbers.push_back(c.value(*step.drive));
  if (!extent.chain) return;
  for (const ColumnOf<DriveRow>& c : surface_columns) numbers.push_back(c.value(*step.drive));
  append(step.nodes);
}

}  // namespace tdbd::simulation
