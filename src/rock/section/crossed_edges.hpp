#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tdbd::rock {

/// A set of directed edges, each identified by its start vertex and its index in that vertex's
/// ring. One entry contains 64 edges of a vertex. clear() takes constant time: it starts a new
/// generation, and entries of earlier generations count as free. A vertex can be marked as done.
class CrossedEdges {
 public:
  void clear();

  /// Adds the edge from v to its neighbour with index i. Returns false if it was in the set
  /// already.
  bool add(int v, int i) {
    std::uint64_t& edges = edges_of(v, i / 64);
    const std::uint64_t edge = std::uint64_t{1} << (i % 64), before = edges;
    edges |= edge;
    return (before & edge) == 0;
  }
  bool contains(int v, int i) { return (edges_of(v, i / 64) >> (i % 64) & std::uint64_t{1}) != 0; }

  /// Marks a vertex as done. An edge of it with an index below 64 must be in the set. Later
  /// additions keep the mark.
  void mark_done(int v) { entries_[place_of(key_of(v, 0))].is_done = true; }
  bool is_done(int v) const {
    const Entry& e = entries_[place_of(key_of(v, 0))];
    return e.generation == generation_ && e.is_done;
  }

 private:
  struct Entry {
    std::uint64_t key = 0, edges = 0;
    std::uint64_t generation = 0;
    bool is_done = false;
  };

  static std::uint64_t key_of(int v, int block) {
    return static_cast<std::uint64_t>(v) << 32U | static_cast<std::uint64_t>(block);
  }

  /// The slot that contains the key, or at which it may be inserted.
  std::size_t place_of(std::uint64_t key) const {
    std::size_t k = static_cast<std::size_t>(key * 0x9E3779B97F4A7C15U >> shift_);
    while (entries_[k].generation == generation_ && entries_[k].key != key)
      k = k + 1 == entries_.size() ? 0 : k + 1;
    return k;
  }
  std::uint64_t& edges_of(int v, int block) {
    const std::uint64_t key = key_of(v, block);
    const std::size_t k = place_of(key);
    return entries_[k].generation == generation_ ? entries_[k].edges : insert(key, k);
  }
  std::uint64_t& insert(std::uint64_t key, std::size_t place);
  void grow();

  std::vector<Entry> entries_ = std::vector<Entry>(256);
  unsigned shift_ = 56;  ///< 64 minus the binary logarithm of the number of entries
  std::uint64_t generation_ = 1;
  std::size_t count_ = 0;
};

}  // namespace tdbd::rock
