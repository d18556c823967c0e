#pragma once

#include <array>

#include "simulation/history.hpp"

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

}  // namespace tdbd::simulation
