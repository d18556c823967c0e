#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace tdbd {

/// Sorts by `before` and keeps the first of adjacent items that are the `same`.
template <class T, class Before, class Same>
void sort_unique(std::vector<T>& items, Before&& before, Same&& same) {
  std::sort(items.begin(), items.end(), before);
  items.erase(std::unique(items.begin(), items.end(), same), items.end());
}

/// Sorts and removes duplicates.
template <class T>
void sort_unique(std::vector<T>& items) {
  sort_unique(items, std::less<T>{}, std::equal_to<T>{});
}

}  // namespace tdbd
