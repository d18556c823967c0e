#include "rock/section/crossed_edges.hpp"

#include <utility>

namespace tdbd::rock {

void CrossedEdges::clear() {
  ++generation_;
  count_ = 0;
}

std::uint64_t& CrossedEdges::insert(std::uint64_t key, std::size_t place) {
  if (2 * count_ >= entries_.size()) {
    grow();
    place = place_of(key);
  }
  ++count_;
  entries_[place] = {key, 0, generation_, false};
  return entries_[place].edges;
}

void CrossedEdges::grow() {
  const std::vector<Entry> old = std::exchange(entries_, std::vector<Entry>(2 * entries_.size()));
  --shift_;
  for (const Entry& e : old)
    if (e.generation == generation_) entries_[place_of(e.key)] = e;
}

}  // namespace tdbd::rock
