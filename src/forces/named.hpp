#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "core/error.hpp"

namespace tdbd::forces {

/// The item with this name; `name_of` returns the name of an item. Throws InputError "found the
/// WHAT "NAME", expected one of ..." if there is none. `what` is the kind of item.
template <class Items, class NameOf>
const auto& item_named(std::string_view what, std::string_view name, const Items& items,
                       NameOf name_of) {
  std::string all;
  for (const auto& item : items) {
    if (name_of(item) == name) return item;
    all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", name_of(item));
  }
  throw InputError(fmt::format("found the {} \"{}\", expected one of {}", what, name, all));
}

}  // namespace tdbd::forces
