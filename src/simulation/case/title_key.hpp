#pragma once

#include "core/config/key.hpp"

/// The key that cases of `tdbd run` and `tdbd rotate` have before their first table.
namespace tdbd::simulation::title_keys {

inline constexpr TableKey table{"", "what stands before the first table"};
inline constexpr TextKey title{
    .name = "title",
    .fallback = "",
    .meaning = "of the case, for summary.json; empty: tdbd run writes the bit's name"};

}  // namespace tdbd::simulation::title_keys
