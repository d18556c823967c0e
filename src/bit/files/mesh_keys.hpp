#pragma once

#include <limits>

#include "bit/bit.hpp"
#include "bit/files/key_ranges.hpp"
#include "core/config/key.hpp"

/// The keys of a bit whose parts come from mesh files.
namespace tdbd::bit {

namespace part_file_keys {

inline constexpr TableKey table{"parts", "a part of the bit from a mesh file", Repeats::yes};

inline constexpr TextKey name{.name = "name",
                              .meaning = "letters, digits, - and _, with / between"};
inline constexpr NameKey kind{
    .name = "kind", .names = &part_kind_names, .meaning = "what the part is"};
inline constexpr PathKey file{
    .name = "file", .meaning = "a closed mesh with outward normals (STL, OBJ, PLY or OFF)"};
inline constexpr QuantityKey unit{.name = "unit",
                                  .unit = "m",
                                  .fallback = 1e-3,
                                  .range = Range::positive(),
                                  .meaning = "length of the mesh file's unit"};
inline constexpr FlagKey cutting{
    .name = "cutting", .usual = "on, except kind bit-body", .meaning = "whether it removes rock"};
inline constexpr FlagKey rubs{
    .name = "rubs",
    .fallback = false,
    .meaning = "not cutting: whether it bears on rock, by the law of its kind"};
inline constexpr QuantityKey density{.name = "density",
                                     .unit = "kg/m3",
                                     .fallback = 0.0,
                                     .range = any_density,
                                     .meaning = "all parts or none have one"};
inline constexpr IntegerKey group{
    .name = "group",
    .fallback = -1,
    .lo = -1,
    .hi = std::numeric_limits<int>::max(),
    .meaning = "parts with one frame and update direction have one group; -1: none"};
inline constexpr VectorKey position{.name = "position",
                                    .unit = "m",
                                    .fallback = {{0.0, 0.0, 0.0}},
                                    .meaning = "of the part's frame in the bit's"};
inline constexpr VectorKey rotation_vector{.name = "rotation_vector",
                                           .unit = "rad",
                                           .fallback = {{0.0, 0.0, 0.0}},
                                           .meaning = "of the part's frame in the bit's"};
inline constexpr VectorKey update_direction{.name = "update_direction",
                                            .usual = "by kind, frame and profile",
                                            .meaning = "at azimuth 0, (x, 0, z)"};

}  // namespace part_file_keys

namespace solids_keys {

inline constexpr TableKey table{"solids", "a whole bit in one mesh file, solids by name"};

inline constexpr auto file = part_file_keys::file;
inline constexpr auto unit = part_file_keys::unit;

}  // namespace solids_keys

namespace solid_rule_keys {

inline constexpr TableKey table{
    "solids.rules", "what holds for the solids that a pattern fits; later rules win", Repeats::yes};

inline constexpr TextKey match{.name = "match",
                               .meaning = "a name; * stands for any text, ? for any character"};
inline constexpr TextKey name{
    .name = "name", .usual = "that of the solid", .meaning = "in place of its own"};
inline constexpr NameKey kind{.name = "kind",
                              .names = &part_kind_names,
                              .usual = "by its name",
                              .meaning = "what the part is"};
inline constexpr FlagKey cutting{.name = "cutting",
                                 .usual = "on, except bodies and cones",
                                 .meaning = "whether it removes rock"};
inline constexpr FlagKey rubs{
    .name = "rubs",
    .usual = "false",
    .meaning = "not cutting: whether it bears on rock, by the law of its kind"};
inline constexpr QuantityKey density{.name = "density",
                                     .unit = "kg/m3",
                                     .usual = "none",
                                     .range = any_density,
                                     .meaning = "of the solid"};
inline constexpr IntegerKey group{.name = "group",
                                  .usual = "by cutter",
                                  .lo = -1,
                                  .hi = std::numeric_limits<int>::max(),
                                  .meaning = "as of parts"};
inline constexpr VectorKey cutter_position{
    .name = "cutter_position",
    .unit = "m",
    .usual = "none",
    .meaning = "centre of the face of the solid's cutter; with it a face carries forces"};
inline constexpr VectorKey cutter_rotation_vector{
    .name = "cutter_rotation_vector",
    .unit = "rad",
    .usual = "none",
    .meaning = "of the cutter's frame: X out of the face, -Z towards the rock"};
inline constexpr auto update_direction = part_file_keys::update_direction;

}  // namespace solid_rule_keys

namespace solid_cone_keys {

inline constexpr TableKey table{
    "solids.cones", "a journal, with the cone of all solids named NAME/...", Repeats::yes};

inline constexpr TextKey name{.name = "name", .meaning = "of the cone: cone-1"};
inline constexpr QuantityKey azimuth{
    .name = "azimuth", .unit = "rad", .meaning = "of the journal about the bit's axis"};
inline constexpr QuantityKey journal_angle{
    .name = "journal_angle",
    .unit = "rad",
    .range = Range::within(-1.5, 1.5),
    .meaning = "of the journal below the plane normal to the bit's axis"};
inline constexpr QuantityKey offset{
    .name = "offset",
    .unit = "m",
    .fallback = 0.0,
    .range = bit_place,
    .meaning = "of the journal's axis, in the sense of the bit's rotation"};
inline constexpr QuantityKey skew{.name = "skew",
                                  .unit = "rad",
                                  .fallback = 0.0,
                                  .meaning = "of the journal's outer end, in the same sense"};
inline constexpr QuantityKey apex{.name = "apex",
                                  .unit = "m",
                                  .fallback = 0.0,
                                  .range = bit_place,
                                  .meaning = "from the journal's foot to the cone's origin"};
inline constexpr QuantityKey foot_height{.name = "foot_height",
                                         .unit = "m",
                                         .fallback = 0.0,
                                         .range = bit_place,
                                         .meaning = "of the journal's foot above the bit's origin"};
inline constexpr QuantityKey rolling_ratio{
    .name = "rolling_ratio",
    .fallback = 0.0,
    .range = Range::within(0.0, 10.0),
    .meaning =
        "speed of a rolling cone over the bit's; 0: computed from the tooth whose tip is farthest "
        "from the bit's axis"};

}  // namespace solid_cone_keys

}  // namespace tdbd::bit
