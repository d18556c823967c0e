#pragma once

#include <numbers>

#include "bit/bit.hpp"
#include "bit/files/key_ranges.hpp"
#include "core/config/key.hpp"

/// The keys of a roller cone bit. The defaults are those of the structs that the keys set.
namespace tdbd::bit {

namespace journal_keys {

inline constexpr TableKey table{"journal",
                                "the journals of all cones; a cone may have its own values"};

inline constexpr QuantityKey angle{
    .name = "angle",
    .unit = "rad",
    .fallback = 0.0,
    .range = Range::within(0.0, 0.5 * std::numbers::pi),
    .meaning = "of the journal below the plane normal to the bit's axis"};
inline constexpr QuantityKey offset{
    .name = "offset",
    .unit = "m",
    .fallback = 0.0,
    .range = bit_place,
    .meaning = "of the journal's axis, in the sense of the bit's rotation"};
inline constexpr QuantityKey skew{
    .name = "skew",
    .unit = "rad",
    .fallback = 0.0,
    .range = Range::within(-0.5 * std::numbers::pi, 0.5 * std::numbers::pi),
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

}  // namespace journal_keys

namespace tooth_keys {

inline constexpr TableKey table{"teeth", "the teeth of all rows; a row may have its own values"};

inline constexpr ChoiceKey<ToothKind> kind{.name = "kind",
                                           .values = {{{"milled-chisel", ToothKind::milled_chisel},
                                                       {"hemispherical", ToothKind::hemispherical},
                                                       {"conical", ToothKind::conical},
                                                       {"chisel", ToothKind::chisel}}},
                                           .fallback = ToothShape{}.kind,
                                           .meaning = "the form of the teeth"};
inline constexpr QuantityKey diameter{
    .name = "diameter",
    .unit = "m",
    .fallback = ToothShape{}.diameter,
    .range = bit_length,
    .meaning = "of an insert's shank; a milled tooth's length at the shell"};
inline constexpr QuantityKey width{.name = "width",
                                   .unit = "m",
                                   .fallback = ToothShape{}.width,
                                   .range = bit_length,
                                   .meaning = "milled: along the circumference, at the shell"};
inline constexpr QuantityKey protrusion{.name = "protrusion",
                                        .unit = "m",
                                        .fallback = ToothShape{}.protrusion,
                                        .range = bit_length,
                                        .meaning = "of the tip above the shell"};
inline constexpr QuantityKey crest_length{.name = "crest_length",
                                          .unit = "m",
                                          .fallback = ToothShape{}.crest_length,
                                          .range = bit_length,
                                          .meaning = "chisels: of the crest"};
inline constexpr QuantityKey crest_width{.name = "crest_width",
                                         .unit = "m",
                                         .fallback = ToothShape{}.crest_width,
                                         .range = bit_length,
                                         .meaning = "chisels: of the crest"};
inline constexpr QuantityKey tip_radius{.name = "tip_radius",
                                        .unit = "m",
                                        .fallback = ToothShape{}.tip_radius,
                                        .range = bit_length,
                                        .meaning = "conical: of the tip"};
inline constexpr QuantityKey embedding{.name = "embedding",
                                       .unit = "m",
                                       .fallback = ToothShape{}.embedding,
                                       .range = bit_length,
                                       .meaning = "depth of the tooth below the shell"};
inline constexpr QuantityKey half_angle{.name = "half_angle",
                                        .unit = "rad",
                                        .fallback = ToothShape{}.half_angle,
                                        .range = Range::within(0.05, 1.5),
                                        .meaning = "conical: of the cone"};
inline constexpr QuantityKey density{.name = "density",
                                     .unit = "kg/m3",
                                     .fallback = ToothShape{}.density,
                                     .range = any_density,
                                     .meaning = "of the teeth"};

}  // namespace tooth_keys

namespace cone_mesh_keys {

inline constexpr TableKey table{"mesh", "the meshes of cones and teeth"};

inline constexpr IntegerKey segments{.name = "segments",
                                     .fallback = ConeLayout::usual_segments,
                                     .lo = 8,
                                     .hi = 4096,
                                     .meaning = "around the shell's mesh"};
inline constexpr IntegerKey facets{.name = "facets",
                                   .fallback = ConeLayout::usual_facets,
                                   .lo = 8,
                                   .hi = 128,
                                   .meaning = "around an insert's mesh, a multiple of 4"};

}  // namespace cone_mesh_keys

namespace bit_cone_keys {

inline constexpr TableKey table{"cones", "a cone with its rows of teeth", Repeats::yes};

inline constexpr QuantityKey azimuth{
    .name = "azimuth", .unit = "rad", .meaning = "of the journal about the bit's axis"};
inline constexpr QuantityKey density{.name = "density",
                                     .unit = "kg/m3",
                                     .fallback = ConeLayout::usual_density,
                                     .range = any_density,
                                     .meaning = "of the shell"};
inline constexpr FlagKey body_cuts{
    .name = "body_cuts",
    .fallback = false,
    .meaning = "whether the shell crushes rock that stands between the prints of teeth"};
inline constexpr PairsKey shell{
    .name = "shell", .unit = "m", .meaning = "[[s, radius], ...] from the nose to the base"};
inline constexpr QuantityKey journal_angle{.name = "journal_angle",
                                           .unit = "rad",
                                           .usual = "that of [journal]",
                                           .range = journal_keys::angle.range,
                                           .meaning = journal_keys::angle.meaning};

}  // namespace bit_cone_keys

namespace tooth_row_keys {

inline constexpr TableKey table{"cones.rows", "a row of equal teeth; also any key of [teeth]",
                                Repeats::yes};

inline constexpr QuantityKey s{
    .name = "s", .unit = "m", .range = bit_place, .meaning = "place of the row on the shell"};
inline constexpr QuantityKey sink{.name = "sink",
                                  .unit = "m",
                                  .fallback = 0.0,
                                  .range = bit_place,
                                  .meaning = "how far the teeth's origins lie below the shell"};
inline constexpr QuantityKey lean{
    .name = "lean",
    .unit = "rad",
    .fallback = 0.0,
    .range = Range::within(-0.5 * std::numbers::pi, 0.5 * std::numbers::pi),
    .meaning = "of the teeth from the shell's normal"};
inline constexpr FlagKey gage{
    .name = "gage", .fallback = false, .meaning = "whether it is a gage row"};
inline constexpr ListKey angles{.name = "angles",
                                .unit = "rad",
                                .usual = "in place of teeth",
                                .meaning = "of the teeth about the journal"};
inline constexpr IntegerKey teeth{.name = "teeth",
                                  .usual = "required without angles",
                                  .lo = 1,
                                  .hi = 1000,
                                  .meaning = "how many"};
inline constexpr QuantityKey first_angle{
    .name = "first_angle", .unit = "rad", .fallback = 0.0, .meaning = "of the first tooth"};
inline constexpr ListKey spacing{.name = "spacing",
                                 .usual = "equal spaces",
                                 .meaning = "ratios of the spaces between teeth, repeated"};

}  // namespace tooth_row_keys

namespace shank_keys {

inline constexpr TableKey table{"shank", "the steel above the cones, a cylinder that never cuts"};

inline constexpr QuantityKey radius{.name = "radius",
                                    .unit = "m",
                                    .fallback = 0.0,
                                    .range = bit_length_or_none,
                                    .meaning = "0: none"};
inline constexpr QuantityKey length{.name = "length",
                                    .unit = "m",
                                    .fallback = 0.1,
                                    .range = bit_length,
                                    .meaning = "along the axis"};
inline constexpr QuantityKey height{.name = "height",
                                    .unit = "m",
                                    .fallback = 0.1,
                                    .range = bit_place,
                                    .meaning = "of its lower end above the bit's origin"};
inline constexpr QuantityKey density{.name = "density",
                                     .unit = "kg/m3",
                                     .fallback = Shank{}.density,
                                     .range = any_density,
                                     .meaning = "of the steel"};

}  // namespace shank_keys

namespace leg_keys {

inline constexpr TableKey table{"legs", "the legs that carry the journals, one for each cone"};

inline constexpr QuantityKey width{
    .name = "width", .unit = "m", .range = bit_length, .meaning = "of a leg, across its journal"};
inline constexpr QuantityKey under_gage{.name = "under_gage",
                                        .unit = "m",
                                        .fallback = Legs{}.under_gage,
                                        .range = bit_length_or_none,
                                        .meaning = "how far the outer side is inside the gage"};
inline constexpr QuantityKey clearance{.name = "clearance",
                                       .unit = "m",
                                       .fallback = Legs{}.clearance,
                                       .range = bit_length,
                                       .meaning = "from the base of the shell to the leg"};
inline constexpr QuantityKey tip_radius{.name = "tip_radius",
                                        .unit = "m",
                                        .usual = "that of the shell's base",
                                        .range = bit_length,
                                        .meaning = "of the shirttail, about the journal"};
inline constexpr QuantityKey shoulder{
    .name = "shoulder",
    .unit = "m",
    .usual = "shank.height",
    .range = bit_length,
    .meaning = "height above the bit's origin at which the outer side leaves the gage"};
inline constexpr QuantityKey top{
    .name = "top",
    .unit = "m",
    .usual = "the middle of the shank",
    .range = bit_length,
    .meaning = "height above the bit's origin at which the outer side meets the shank"};
inline constexpr QuantityKey density{.name = "density",
                                     .unit = "kg/m3",
                                     .fallback = Legs{}.density,
                                     .range = any_density,
                                     .meaning = "of the steel"};
inline constexpr FlagKey rubs{.name = "rubs",
                              .fallback = true,
                              .meaning =
                                  "whether legs and their inserts bear on rock by the laws "
                                  "of forces.bit_body and forces.gage_pad"};
inline constexpr IntegerKey inserts{.name = "inserts",
                                    .fallback = Legs{}.inserts,
                                    .hi = 64,
                                    .meaning = "in the outer side of each leg, in a column"};
inline constexpr QuantityKey insert_diameter{.name = "insert_diameter",
                                             .unit = "m",
                                             .fallback = Legs{}.insert_diameter,
                                             .range = bit_length,
                                             .meaning = "of an insert"};
inline constexpr QuantityKey insert_length{.name = "insert_length",
                                           .unit = "m",
                                           .fallback = Legs{}.insert_length,
                                           .range = bit_length,
                                           .meaning = "of an insert"};
inline constexpr QuantityKey insert_protrusion{
    .name = "insert_protrusion",
    .unit = "m",
    .fallback = Legs{}.insert_protrusion,
    .range = bit_length_or_none,
    .meaning = "of the flat face of an insert out of the leg, in its middle"};

}  // namespace leg_keys

namespace cone_bit_keys {

enum class Interference { refuse, report };
inline constexpr ChoiceKey<Interference> interference{
    .name = "interference",
    .values = {{{"refuse", Interference::refuse}, {"report", Interference::report}}},
    .fallback = Interference::refuse,
    .meaning = "whether cones may overlap one another and legs"};

}  // namespace cone_bit_keys

}  // namespace tdbd::bit
