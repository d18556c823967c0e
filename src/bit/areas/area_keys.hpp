#pragma once

#include <limits>

#include "bit/bit.hpp"
#include "core/config/key.hpp"

/// The keys that select the parts of an area, in [areas.NAME] of a bit file and in
/// [forces.areas.NAME] of a case.
namespace tdbd::bit::area_keys {

inline constexpr NameKey kind{
    .name = "kind", .names = &part_kind_names, .usual = "any", .meaning = "the parts of this kind"};
inline constexpr TextKey zone{
    .name = "zone",
    .usual = "any",
    .meaning =
        "the parts of cutters with this label (cone, nose, shoulder, gage, or that of the "
        "table); gage: also gage pads and the teeth of gage rows"};
inline constexpr IntegerKey blade{.name = "blade",
                                  .usual = "any",
                                  .hi = std::numeric_limits<int>::max(),
                                  .meaning = "the parts of the cutters on this blade"};
inline constexpr IntegerKey cone{.name = "cone",
                                 .usual = "any",
                                 .lo = 1,
                                 .hi = std::numeric_limits<int>::max() - 1,
                                 .meaning = "the parts of cone-K"};
inline constexpr IntegerKey row{.name = "row",
                                .usual = "any",
                                .lo = 1,
                                .hi = std::numeric_limits<int>::max() - 1,
                                .meaning = "the teeth of row-J, of every cone"};
inline constexpr TextKey names{
    .name = "names",
    .usual = "any",
    .meaning = "the parts whose names match: * stands for any text, ? for any character"};
inline constexpr TextKey part{.name = "part", .usual = "any", .meaning = "the part of this name"};

}  // namespace tdbd::bit::area_keys
