#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"

/// The table [adjust] of a bit file: changes of a layout's values, which a sweep may vary.
namespace tdbd::bit {

namespace adjust_keys {

inline constexpr TableKey table{
    "adjust", "changes of a layout: of all cutters, of [adjust.blade.N], of [adjust.cutter.N]"};
inline constexpr TableKey blade{"blade", "changes of the cutters of one blade, by its number"};
inline constexpr TableKey cutter{"cutter", "changes of one cutter, by its number"};

inline constexpr QuantityKey azimuth{.name = "azimuth",
                                     .unit = "rad",
                                     .fallback = 0.0,
                                     .meaning = "turns cutters about the bit's axis"};
inline constexpr QuantityKey back_rake{
    .name = "back_rake", .unit = "rad", .fallback = 0.0, .meaning = "is added to the back rake"};
inline constexpr QuantityKey side_rake{
    .name = "side_rake", .unit = "rad", .fallback = 0.0, .meaning = "is added to the side rake"};
inline constexpr QuantityKey along{
    .name = "along",
    .unit = "m",
    .fallback = 0.0,
    .meaning = "moves a cutter outwards along its profile's tangent"};

}  // namespace adjust_keys

/// Reads [adjust] and changes the cutters; changes are added up. Records as mistakes blades and
/// cutters that the bit does not have, and rakes or positions that no cutter can have.
void adjust_cutters(Config adjust, std::vector<Cutter>& cutters);

}  // namespace tdbd::bit
