#pragma once

#include <array>

#include "simulation/result/history.hpp"

namespace tdbd::simulation {

/// One bit-level number of a row: a variable of `history.nc`, a column of `history.csv`.
struct HistoryColumn {
  const char* name;
  const char* units;  ///< as UDUNITS reads them; "1" for counts
  const char* long_name;
  double (*value)(const HistoryRow&);
};

/// Every bit-level column, in the order of the files. A new one is one line here.
inline constexpr std::array history_columns = {
    HistoryColumn{"time", "s", "time at the end of the step",
                  [](const HistoryRow& r) { return r.time; }},
    HistoryColumn{"position_x", "m", "origin of the bit in space, x",
                  [](const HistoryRow& r) { return r.p_WB.x(); }},
    HistoryColumn{"position_y", "m", "origin of the bit in space, y",
                  [](const HistoryRow& r) { return r.p_WB.y(); }},
    HistoryColumn{"position_z", "m", "origin of the bit in space, z (down)",
                  [](const HistoryRow& r) { return r.p_WB.z(); }},
    HistoryColumn{"rotation_vector_x", "rad", "attitude of the bit, rotation vector, x",
                  [](const HistoryRow& r) { return r.rotation_vector.x(); }},
    HistoryColumn{"rotation_vector_y", "rad", "attitude of the bit, rotation vector, y",
                  [](const HistoryRow& r) { return r.rotation_vector.y(); }},
    HistoryColumn{"rotation_vector_z", "rad", "attitude of the bit, rotation vector, z",
                  [](const HistoryRow& r) { return r.rotation_vector.z(); }},
    HistoryColumn{"rotation_angle", "rad", "angle turned about the bit's axis since the start",
                  [](const HistoryRow& r) { return r.rotation_angle; }},
    HistoryColumn{"removed_volume_total", "m3", "rock removed by all parts since the start",
                  [](const HistoryRow& r) { return r.removed_volume_total; }},
    HistoryColumn{"swept_vertices", "1", "rock vertices moved in the step",
                  [](const HistoryRow& r) { return static_cast<double>(r.swept_vertices); }},
    HistoryColumn{"rock_triangles", "1", "triangles of the rock surface",
                  [](const HistoryRow& r) { return static_cast<double>(r.rock_triangles); }},
};

/// One number of a cutter's section: a variable over time and cutter.
struct SectionColumn {
  const char* name;
  const char* units;
  const char* long_name;
  double (*value)(const rock::Section&);
};

/// Of rock::Section, in its order; a cutter that is not in rock has 0 everywhere.
inline constexpr std::array section_columns = {
    SectionColumn{"section_area", "m2", "uncut rock in the plane of the cutter's face",
                  [](const rock::Section& s) { return s.area; }},
    SectionColumn{"section_centroid_x", "m", "centroid of the section in the bit's frame, x",
                  [](const rock::Section& s) { return s.centroid_B.x(); }},
    SectionColumn{"section_centroid_y", "m", "centroid of the section in the bit's frame, y",
                  [](const rock::Section& s) { return s.centroid_B.y(); }},
    SectionColumn{"section_centroid_z", "m", "centroid of the section in the bit's frame, z",
                  [](const rock::Section& s) { return s.centroid_B.z(); }},
    SectionColumn{"section_engaged_edge", "m", "length of the cutter's outline in rock",
                  [](const rock::Section& s) { return s.engaged_edge; }},
    SectionColumn{"section_angle_of_attack", "rad",
                  "angle between face and path, mean along the engaged edge",
                  [](const rock::Section& s) { return s.angle_of_attack; }},
    SectionColumn{"section_volume_rate", "m3 s-1", "volume that the section sweeps",
                  [](const rock::Section& s) { return s.volume_rate; }},
};

/// Sums over the cutters, for the csv too.
inline constexpr std::array section_totals = {
    SectionColumn{"section_area_total", "m2", "sections of all cutters",
                  [](const rock::Section& s) { return s.area; }},
    SectionColumn{"section_volume_rate_total", "m3 s-1", "volume that all sections sweep",
                  [](const rock::Section& s) { return s.volume_rate; }},
};

/// One number of the bit's loads.
struct LoadColumn {
  const char* name;
  const char* units;
  const char* long_name;
  double (*value)(const LoadedStep&);
};

/// Formulation 0: weight and torque on bit are positive while drilling.
inline constexpr std::array load_columns = {
    LoadColumn{"weight_on_bit", "N", "force of the bit on the rock, z",
               [](const LoadedStep& s) { return -s.loads.force_W.z(); }},
    LoadColumn{"torque_on_bit", "N m", "torque of the bit on the rock about its origin, z",
               [](const LoadedStep& s) { return -s.loads.torque_W.z(); }},
    LoadColumn{"force_x", "N", "force of the rock on the bit in space, x",
               [](const LoadedStep& s) { return s.loads.force_W.x(); }},
    LoadColumn{"force_y", "N", "force of the rock on the bit in space, y",
               [](const LoadedStep& s) { return s.loads.force_W.y(); }},
    LoadColumn{"torque_x", "N m", "torque of the rock on the bit about its origin, x",
               [](const LoadedStep& s) { return s.loads.torque_W.x(); }},
    LoadColumn{"torque_y", "N m", "torque of the rock on the bit about its origin, y",
               [](const LoadedStep& s) { return s.loads.torque_W.y(); }},
    LoadColumn{"drilling_power", "W", "power that the bit spends on the rock",
               [](const LoadedStep& s) { return s.loads.power; }},
    LoadColumn{"velocity_x", "m s-1", "velocity of the bit's origin over the rock, x",
               [](const LoadedStep& s) { return s.velocity.v_W.x(); }},
    LoadColumn{"velocity_y", "m s-1", "velocity of the bit's origin over the rock, y",
               [](const LoadedStep& s) { return s.velocity.v_W.y(); }},
    LoadColumn{"rate_of_penetration", "m s-1", "velocity of the bit's origin over the rock, z",
               [](const LoadedStep& s) { return s.velocity.v_W.z(); }},
    LoadColumn{"rotary_speed", "rad s-1", "angular velocity of the bit about its axis",
               [](const LoadedStep& s) { return s.velocity.w_W.dot(s.X_WB.R.col(2)); }},
};

/// One number of the motion of a bit that forces move.
struct DriveColumn {
  const char* name;
  const char* units;
  const char* long_name;
  double (*value)(const DriveRow&);
};

inline constexpr std::array drive_columns = {
    DriveColumn{"rock_position_z", "m", "how far the rock has moved along z",
                [](const DriveRow& r) { return r.rock_z; }},
    DriveColumn{"string_twist", "rad", "angle of the string's top over that of the bit",
                [](const DriveRow& r) { return r.string_twist; }},
    DriveColumn{"energy_stored", "J", "kinetic and elastic energy of bit, string and rock",
                [](const DriveRow& r) { return r.stored; }},
    DriveColumn{"work_of_top", "J", "work of the top since the start",
                [](const DriveRow& r) { return r.top; }},
    DriveColumn{"work_on_rock", "J", "work that cutting took from the bit since the start",
                [](const DriveRow& r) { return r.cutting; }},
    DriveColumn{"energy_lost", "J", "taken by dampers and by the wall since the start",
                [](const DriveRow& r) { return r.lost; }},
    DriveColumn{"energy_residual", "J", "what the ledger of energy does not account for",
                [](const DriveRow& r) { return r.residual; }},
};

/// One number of a part's load: a variable over time and part.
struct PartLoadColumn {
  const char* name;
  const char* units;
  const char* long_name;
  double (*value)(const PartLoad&);
};

inline constexpr std::array part_load_columns = {
    PartLoadColumn{"force_normal", "N", "force of the part along the normal into the rock",
                   [](const PartLoad& p) { return p.normal; }},
    PartLoadColumn{"force_tangential", "N", "force of the part along its velocity",
                   [](const PartLoad& p) { return p.tangential; }},
    PartLoadColumn{"part_force_x", "N", "force of the rock on the part in space, x",
                   [](const PartLoad& p) { return p.force_W.x(); }},
    PartLoadColumn{"part_force_y", "N", "force of the rock on the part in space, y",
                   [](const PartLoad& p) { return p.force_W.y(); }},
    PartLoadColumn{"part_force_z", "N", "force of the rock on the part in space, z",
                   [](const PartLoad& p) { return p.force_W.z(); }},
    PartLoadColumn{"part_power", "W", "power that the part spends on the rock",
                   [](const PartLoad& p) { return p.power; }},
};

}  // namespace tdbd::simulation
