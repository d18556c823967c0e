#pragma once

#include "bit/files/key_ranges.hpp"
#include "bit/pdc/pdc_design.hpp"
#include "core/config/key.hpp"

/// The keys of [design]: a PDC layout by rules.
namespace tdbd::bit {

namespace design_keys {

inline constexpr TableKey table{"design", "a PDC layout by rules, in place of a cutter table"};

inline constexpr QuantityKey first_radius{.name = "first_radius",
                                          .unit = "m",
                                          .range = bit_length_or_none,
                                          .meaning = "of the tip nearest to the axis"};
inline constexpr QuantityKey spiral{.name = "spiral",
                                    .unit = "rad",
                                    .fallback = 0.0,
                                    .meaning = "angle by which a blade trails at the gage"};
inline constexpr QuantityKey clearance{.name = "clearance",
                                       .unit = "m",
                                       .fallback = PdcDesign::usual_clearance,
                                       .range = bit_length,
                                       .meaning = "smallest gap between two cutters"};

}  // namespace design_keys

namespace profile_keys {

inline constexpr TableKey table{"design.profile",
                                "the profile of the tips: cone, nose, shoulder, gage"};

inline constexpr QuantityKey cone_angle{.name = "cone_angle",
                                        .unit = "rad",
                                        .range = Range::non_negative(),
                                        .meaning = "of the cone with the horizontal"};
inline constexpr QuantityKey nose_place{
    .name = "nose_place",
    .unit = "m",
    .range = bit_length,
    .meaning = "radius at which the nose's arc has its lowest point"};
inline constexpr QuantityKey nose_radius{
    .name = "nose_radius", .unit = "m", .range = bit_length, .meaning = "of the nose's arc"};
inline constexpr QuantityKey shoulder_angle{.name = "shoulder_angle",
                                            .unit = "rad",
                                            .usual = "required without shoulder_radius",
                                            .range = Range::non_negative(),
                                            .meaning = "at which the shoulder's arc begins"};
inline constexpr QuantityKey shoulder_radius{.name = "shoulder_radius",
                                             .unit = "m",
                                             .usual = "in place of shoulder_angle",
                                             .range = bit_length,
                                             .meaning = "of the shoulder's arc"};
inline constexpr QuantityKey gage_length{.name = "gage_length",
                                         .unit = "m",
                                         .fallback = 0.05,
                                         .range = bit_length_or_none,
                                         .meaning = "of the gage"};

}  // namespace profile_keys

namespace design_blade_keys {

inline constexpr TableKey table{"design.blades", "a blade of the layout", Repeats::yes};

inline constexpr QuantityKey azimuth{
    .name = "azimuth", .unit = "rad", .meaning = "on the bit's axis"};
inline constexpr QuantityKey start{.name = "start",
                                   .unit = "m",
                                   .fallback = 0.0,
                                   .range = bit_length_or_none,
                                   .meaning = "radius from which the blade carries cutters"};
inline constexpr FlagKey backups{.name = "backups",
                                 .fallback = false,
                                 .meaning = "whether backup cutters stand behind its face cutters"};

}  // namespace design_blade_keys

namespace region_keys {

inline constexpr TableKey diameter{"design.diameter", "of cutters, by region, one value in each"};
inline constexpr TableKey overlap{"design.overlap",
                                  "least overlap of neighbours on the profile, over a diameter"};
inline constexpr TableKey back_rake{"design.back_rake", "of cutters, linear between the places"};
inline constexpr TableKey side_rake{"design.side_rake", "of cutters, linear between the places"};
inline constexpr TableKey wear{"design.wear",
                               "height of the wear flats, linear between the places"};

/// The keys of a table of regions. The first is required or has a default; each other key defaults
/// to the previous one.
struct Keys {
  QuantityKey first, nose, shoulder, gage;
};
constexpr Keys keys_of(std::string_view first, std::string_view unit, Range range,
                       std::optional<double> fallback) {
  constexpr std::string_view before = "that of the place before";
  return {
      {.name = first,
       .unit = unit,
       .fallback = fallback,
       .range = range,
       .meaning = "the first region"},
      {.name = "nose",
       .unit = unit,
       .usual = before,
       .range = range,
       .meaning = "from the nose on"},
      {.name = "shoulder",
       .unit = unit,
       .usual = before,
       .range = range,
       .meaning = "from the shoulder on"},
      {.name = "gage", .unit = unit, .usual = before, .range = range, .meaning = "on the gage"}};
}
inline constexpr Keys diameters = keys_of("cone", "m", Range::positive(), std::nullopt);
inline constexpr Keys overlaps = keys_of("axis", "1", {}, std::nullopt);
inline constexpr Keys back_rakes = keys_of("axis", "rad", {}, std::nullopt);
inline constexpr Keys side_rakes = keys_of("axis", "rad", {}, 0.0);
inline constexpr Keys wears = keys_of("axis", "m", {}, 0.0);

}  // namespace region_keys

namespace backup_keys {

inline constexpr TableKey table{"design.backup", "cutters behind face cutters"};

inline constexpr QuantityKey from{.name = "from",
                                  .unit = "m",
                                  .fallback = BackupRow{}.from,
                                  .range = bit_length_or_none,
                                  .meaning = "smallest radius of the face cutters that get one"};
inline constexpr QuantityKey to{.name = "to",
                                .unit = "m",
                                .fallback = BackupRow{}.to,
                                .range = Range::positive(),
                                .meaning = "largest radius of them"};
inline constexpr QuantityKey under_exposure{.name = "under_exposure",
                                            .unit = "m",
                                            .fallback = BackupRow{}.under_exposure,
                                            .range = bit_length_or_none,
                                            .meaning = "how far it stays inside the profile"};
inline constexpr QuantityKey behind{.name = "behind",
                                    .unit = "m",
                                    .fallback = BackupRow{}.behind,
                                    .range = bit_length,
                                    .meaning = "from face to face along the circle"};

}  // namespace backup_keys

namespace gage_row_keys {

inline constexpr TableKey table{"design.gage", "cutters on every blade's gage"};

inline constexpr IntegerKey cutters{
    .name = "cutters", .fallback = GageRow{}.cutters, .hi = 100, .meaning = "on each blade"};
inline constexpr QuantityKey start{
    .name = "start",
    .fallback = GageRow{}.start,
    .range = Range::non_negative(),
    .meaning = "from the gage's lower end to the first, over a diameter"};
inline constexpr QuantityKey spacing{.name = "spacing",
                                     .fallback = GageRow{}.spacing,
                                     .range = Range::positive(),
                                     .meaning = "between them, over a diameter"};

}  // namespace gage_row_keys

}  // namespace tdbd::bit
