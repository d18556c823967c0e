#pragma once

#include "core/config/key.hpp"

/// The keys of [spalling] and, for the faces of an area, of [spalling.areas.NAME].
namespace tdbd::simulation::spalling_keys {

inline constexpr TableKey table{
    "spalling", "rock that breaks out around the faces of cutters (off without it)"};
inline constexpr TableKey areas_table{
    "spalling.areas.NAME",
    "another angle or other shares for the faces that meet all criteria given here; of several "
    "areas the one with the most particular criterion decides each of them"};
inline constexpr TableKey areas{"areas", areas_table.meaning};

inline constexpr QuantityKey angle{
    .name = "angle",
    .unit = "rad",
    .meaning =
        "between a crack and the normal of the bit's profile, in (0, 90) degrees: 0 is the wall "
        "of a groove, 90 degrees the free surface"};
inline constexpr QuantityKey depth_share{
    .name = "depth_share",
    .fallback = 1.0,
    .range = Range::within(0.0, 1.0),
    .meaning =
        "share of the engaged depth, from the free surface down, in which cracks start; 0: no "
        "rock breaks out beside the face"};
inline constexpr QuantityKey ahead_share{
    .name = "ahead_share",
    .fallback = 0.0,
    .range = Range::within(0.0, 0.95),
    .meaning =
        "share of the engaged depth, from the free surface down, that chips off ahead of a face, "
        "which then cuts what is left"};
inline constexpr QuantityKey up_to_pressure{
    .name = "up_to_pressure",
    .unit = "Pa",
    .fallback = 1e6,
    .range = Range::non_negative(),
    .meaning = "confining pressure above which no rock breaks out; assumed"};
inline constexpr TextKey material{.name = "material",
                                  .usual = "any",
                                  .meaning = "the rock that breaks out, by its name in [rock]"};

}  // namespace tdbd::simulation::spalling_keys
