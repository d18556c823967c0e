#pragma once

#include "bit/body/blade_shape.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "bit/files/key_ranges.hpp"
#include "bit/pdc/pdc_bit.hpp"
#include "core/config/key.hpp"

/// The keys of a bit file: its top level, and the tables of a bit with PDC cutters. The defaults
/// are those of the structs that the keys set.
namespace tdbd::bit {

namespace bit_file_keys {

inline constexpr TableKey table{"", "what stands before the first table"};

inline constexpr TextKey name{.name = "name", .meaning = "of the bit"};
inline constexpr PathKey cutter_table{.name = "table",
                                      .usual = "one of table, design, parts, solids, cones",
                                      .meaning = "the cutter table (CSV)"};
inline constexpr QuantityKey gage_diameter{.name = "gage_diameter",
                                           .unit = "m",
                                           .usual = "no limit; required with a design",
                                           .range = bit_length,
                                           .meaning = "no cutter or tooth reaches outside it"};
inline constexpr FlagKey unit_check{
    .name = "unit_check",
    .fallback = true,
    .meaning = "parts or solids: whether to refuse sizes that no bit has"};

}  // namespace bit_file_keys

namespace cutter_keys {

inline constexpr TableKey table{"cutters",
                                "the shape of cutters whose row of the table does not give it"};

inline constexpr QuantityKey chamfer{.name = "chamfer",
                                     .unit = "m",
                                     .fallback = 0.0,
                                     .range = bit_length_or_none,
                                     .meaning = "width of the chamfer along the face; 0: sharp"};
inline constexpr QuantityKey chamfer_angle{.name = "chamfer_angle",
                                           .unit = "rad",
                                           .fallback = CutterDefaults{}.chamfer_angle,
                                           .range = Range::within(0.05, 1.5),
                                           .meaning = "of the chamfer, from the cutter's axis"};
inline constexpr QuantityKey length{.name = "length",
                                    .unit = "m",
                                    .fallback = CutterDefaults{}.length,
                                    .range = bit_length,
                                    .meaning = "of the cutter along its axis"};
inline constexpr QuantityKey table_thickness{.name = "table_thickness",
                                             .unit = "m",
                                             .fallback = CutterDefaults{}.table_thickness,
                                             .range = bit_length,
                                             .meaning = "of the diamond table"};
inline constexpr QuantityKey land{.name = "land",
                                  .unit = "m",
                                  .fallback = CutterDefaults{}.land,
                                  .range = bit_length_or_none,
                                  .meaning = "width of a second chamfer inside the first; 0: none"};
inline constexpr QuantityKey land_angle{
    .name = "land_angle",
    .unit = "rad",
    .fallback = CutterDefaults{}.land_angle,
    .range = Range::within(0.05, 1.5),
    .meaning = "of that second chamfer, from the cutter's axis"};

}  // namespace cutter_keys

namespace cutter_mesh_keys {

inline constexpr TableKey table{"mesh", "the meshes of cutters"};

inline constexpr ChoiceKey<Grading> grading{
    .name = "grading",
    .values = {{{"graded", Grading::graded}, {"uniform", Grading::uniform}}},
    .fallback = CutterMeshing{}.grading,
    .meaning = "fine along the rim, or of one edge length"};
inline constexpr IntegerKey rim_segments{.name = "rim_segments",
                                         .fallback = CutterMeshing{}.rim_segments,
                                         .lo = 8,
                                         .hi = 4096,
                                         .meaning = "edges around a rim; graded"};
inline constexpr QuantityKey uniform_edge{.name = "uniform_edge",
                                          .unit = "m",
                                          .fallback = CutterMeshing{}.uniform_edge,
                                          .range = bit_length,
                                          .meaning = "edge length; uniform"};

}  // namespace cutter_mesh_keys

namespace gage_pad_keys {

inline constexpr TableKey table{"gage_pads", "pads on the gage, equally spaced"};

inline constexpr IntegerKey count{
    .name = "count", .fallback = GagePads{}.count, .hi = 64, .meaning = "of pads"};
inline constexpr QuantityKey length{.name = "length",
                                    .unit = "m",
                                    .fallback = GagePads{}.length,
                                    .range = bit_length,
                                    .meaning = "along the bit's axis"};
inline constexpr QuantityKey width{.name = "width",
                                   .unit = "m",
                                   .fallback = GagePads{}.width,
                                   .range = bit_length,
                                   .meaning = "along the circumference"};
inline constexpr QuantityKey under_gage{.name = "under_gage",
                                        .unit = "m",
                                        .fallback = GagePads{}.under_gage,
                                        .range = bit_length_or_none,
                                        .meaning = "how far pads stay inside the gage radius"};
inline constexpr QuantityKey thickness{.name = "thickness",
                                       .unit = "m",
                                       .fallback = GagePads{}.thickness,
                                       .range = bit_length,
                                       .meaning = "radial, in the middle"};
inline constexpr QuantityKey behind{
    .name = "behind",
    .unit = "m",
    .fallback = GagePads{}.behind,
    .range = bit_place,
    .meaning = "along the circumference, from the highest cutter back to the first pad's middle"};

}  // namespace gage_pad_keys

namespace blade_keys {

inline constexpr TableKey table{"blades", "a body with blades and junk slots"};

inline constexpr QuantityKey exposure{.name = "exposure",
                                      .unit = "m",
                                      .range = bit_length,
                                      .meaning = "of a face cutter's tip over its blade"};
inline constexpr QuantityKey slot_depth{.name = "slot_depth",
                                        .unit = "m",
                                        .range = bit_length,
                                        .meaning = "from a blade's top to the floor of the slot"};
inline constexpr QuantityKey width{.name = "width",
                                   .unit = "m",
                                   .fallback = BladeOptions{}.width,
                                   .range = bit_length_or_none,
                                   .meaning = "of a blade's top; 0: what its cutters need"};
inline constexpr QuantityKey wall{.name = "wall",
                                  .unit = "m",
                                  .fallback = BladeOptions{}.wall,
                                  .range = bit_length,
                                  .meaning = "run of a slot's wall, from top to floor"};
inline constexpr QuantityKey gage_length{.name = "gage_length",
                                         .unit = "m",
                                         .fallback = BladeOptions{}.gage_length,
                                         .range = bit_length,
                                         .meaning = "of the blades above the last face cutter"};
inline constexpr QuantityKey neck{.name = "neck",
                                  .unit = "m",
                                  .fallback = BladeOptions{}.neck,
                                  .range = bit_length,
                                  .meaning = "height over which the gage becomes the shank"};
inline constexpr QuantityKey shank_radius{.name = "shank_radius",
                                          .fallback = BladeOptions{}.shank_radius,
                                          .range = Range::within(0.1, 0.9),
                                          .meaning = "over the gage radius"};
inline constexpr QuantityKey shank_length{.name = "shank_length",
                                          .fallback = BladeOptions{}.shank_length,
                                          .range = Range::within(0.1, 10.0),
                                          .meaning = "over the gage radius"};
inline constexpr QuantityKey edge{.name = "edge",
                                  .unit = "m",
                                  .fallback = BladeOptions{}.edge,
                                  .range = Range::within(0.0002, 0.05),
                                  .meaning = "largest edge of the mesh"};
inline constexpr QuantityKey density{.name = "density",
                                     .unit = "kg/m3",
                                     .fallback = BladeOptions{}.density,
                                     .range = any_density,
                                     .meaning = "of the body"};
inline constexpr FlagKey rubs{
    .name = "rubs",
    .fallback = true,
    .meaning = "whether its clearance is measured, and it bears by forces.bit_body"};
inline constexpr FlagKey cuts{
    .name = "cuts", .fallback = false, .meaning = "whether the body removes rock"};

}  // namespace blade_keys

}  // namespace tdbd::bit
