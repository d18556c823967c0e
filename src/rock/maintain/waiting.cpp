#include "rock/maintain/waiting.hpp"

#include "rock/maintain/star.hpp"
#include "rock/maintain/turned_over.hpp"

namespace tdbd::rock {
namespace {

bool is_folded_at(const mesh::Surface& s, const MaintenanceLimits& limits, int v) {
  bool found = false;
  mesh::visit_corners(s, v, [&](int c) { found = found || is_turned_over(s, limits, c / 3); });
  return found;
}

}  // namespace

bool is_due(const Rock& rock, const MaintenanceLimits& limits, int v) {
  return has_waited(rock, limits, v) || is_folded_at(rock.surface, limits, v);
}

void set_aside(Rock& rock, const MaintenanceLimits& limits, std::vector<int>& waiting) {
  waiting.resize(rock.touched_list.size());
  std::size_t kept = 0, waits = 0;
  for (const int v : rock.touched_list) {
    const bool is_alive = rock.surface.is_alive(v);
    if (is_alive &&
        (has_waited(rock, limits, v) || is_turned_over_at(rock.surface, limits, v, rock.notes))) {
      rock.touched_list[kept++] = v;
      continue;
    }
    rock.touched[at(v)] = 0;
    if (is_alive) waiting[waits++] = v;
  }
  rock.touched_list.resize(kept);
  waiting.resize(waits);
}

void list_again(Rock& rock, const MaintenanceLimits& limits, const std::vector<int>& waiting) {
  for (const int v : rock.touched_list) rock.touched[at(v)] = 0;
  rock.touched_list.resize(waiting.size());
  std::size_t listed = 0;
  for (const int v : waiting) {  // a new vertex in the slot of a deleted one does not wait
    if (!rock.surface.is_alive(v) || has_waited(rock, limits, v)) continue;
    rock.touched[at(v)] = touched_mark;  // not by touch(), because the vertex did not change
    rock.touched_list[listed++] = v;
  }
  rock.touched_list.resize(listed);
}

void divide_cuts(Rock& rock, int parts) {
  rock.cuts *= parts;
  for (MovedIn& moved : rock.moved_in)
    for (int* cut : {&moved.first, &moved.last})
      if (*cut != MovedIn::never) *cut *= parts;
}

}  // namespace tdbd::rock
