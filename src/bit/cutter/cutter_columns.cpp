#include "bit/cutter/cutter_columns.hpp"

#include <array>
#include <numbers>

namespace tdbd::bit {
namespace {

constexpr double mm = 1e-3;
constexpr double deg = std::numbers::pi / 180.0;
constexpr double tiny = 1e-6;  ///< "positive": more than a nanometre, in mm
constexpr double large = 1e4;  ///< mm: no bit is 10 m wide

constexpr std::array<NumberColumn, 15> columns{{
    {"dia_mm", &Cutter::diameter, mm, true, tiny, large, "a positive diameter"},
    {"r_tip_mm", &Cutter::tip_radius, mm, true, 0, large, "a radius >= 0"},
    {"phi_deg", &Cutter::azimuth, deg, true, -360, 360, "an angle in -360..360"},
    {"h_tip_mm", &Cutter::tip_height, mm, true, -large, large, "a height"},
    {"profile_angle_deg", &Cutter::profile_angle, deg, true, -90, 100, "an angle in -90..100"},
    {"back_rake_deg", &Cutter::back_rake, deg, true, -5, 60, "an angle in -5..60"},
    {"side_rake_deg", &Cutter::side_rake, deg, true, -45, 45, "an angle in -45..45"},
    {"chamfer_mm", &Cutter::chamfer, mm, false, 0, large, "a width >= 0"},
    {"chamfer_deg", &Cutter::chamfer_angle, deg, false, 10, 80, "an angle in 10..80"},
    {"length_mm", &Cutter::length, mm, false, tiny, large, "a positive length"},
    {"table_mm", &Cutter::table_thickness, mm, false, tiny, large, "a positive thickness"},
    {"land_mm", &Cutter::land, mm, false, 0, large, "a width >= 0"},
    {"land_deg", &Cutter::land_angle, deg, false, 10, 85, "an angle in 10..85"},
    {"wear_mm", &Cutter::wear, mm, false, 0, large, "a height >= 0"},
    {"under_exposure_mm", &Cutter::under_exposure, mm, false, 0, large, "a depth >= 0"},
}};

}  // namespace

std::span<const NumberColumn> number_columns() { return columns; }

}  // namespace tdbd::bit
