#pragma once

#include "rock/index/near_list.hpp"

namespace tdbd::rock {

/// Makes room for this many places and one pack more. Does not preserve the contents.
void make_room(NearList& list, std::size_t places);

/// Completes a list after its first `places` places were written: pads them to whole packs,
/// computes the balls around the packs, and discards the table of places.
void close(NearList& list, std::size_t places);

/// Returned by place_of if a vertex is not in the list.
inline constexpr std::size_t no_place = ~std::size_t{0};

/// Returns the place of vertex v, or no_place if it is not in the list. The first call after the
/// list was made fills its hash table (open addressing, linear probing, at least two slots per
/// vertex).
std::size_t place_of(NearList& list, int v);

/// Appends a vertex that is not yet in the list.
void append(NearList& list, int v, const Vec3& x_W);

/// Removes the vertex at a place from the list.
void take_out(NearList& list, std::size_t i);

}  // namespace tdbd::rock
