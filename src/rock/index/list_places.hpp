#pragma once

#include "rock/index/near_list.hpp"

namespace tdbd::rock {

/// Makes room for this many places and a pack more; what is there may be overwritten.
void make_room(NearList& list, std::size_t places);

/// Ends the writing of the first `places` places: pads them to whole packs, makes the balls about the
/// middles of the packs' boxes, forgets the table of places.
void close(NearList& list, std::size_t places);

/// A number that is no place.
inline constexpr std::size_t no_place = ~std::size_t{0};

/// The place of vertex v, no_place if it is not in the list. The first question after the list was
/// made fills its table: open, of two places or more for each vertex, probed in line.
std::size_t place_of(NearList& list, int v);

/// Appends a vertex that is not in the list.
void append(NearList& list, int v, const Vec3& x_W);

/// Takes the vertex at a place out of the list.
void take_out(NearList& list, std::size_t i);

}  // namespace tdbd::rock
