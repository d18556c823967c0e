#pragma once

#include <cstdint>
#include <vector>

#include "core/single.hpp"
#include "mesh/surface.hpp"
#include "rock/maintain/limits.hpp"

namespace tdbd::rock {

/// What a look at all triangles around a vertex tells of those that may be turned over (star.hpp).
/// Conservative: what it rules out is ruled out.
struct RingTurns {
  int asked = 0;             ///< TurnSieve::now when it was found
  std::uint8_t leaning = 0;  ///< bit i: triangle i of the star may not face up
  bool may_fold = false;     ///< one that leans may be turned over against another of the star
};

/// Which triangles are turned over, asked of the rings of their corners first: eight triangles at
/// once, each ring once in a maintenance unless it changes. The answers are those of star.hpp.
struct TurnSieve {
  std::vector<RingTurns> rings;  ///< by vertex
  int now = 0;
  Single sine2 = 0;  ///< of the steepest overhang, squared
};

/// Begins anew, of a surface that may have changed anywhere.
void start_asking(const mesh::Surface& s, const MaintenanceLimits& limits, TurnSieve& sieve);

/// The rings of these vertices have changed: they or a neighbour moved, or have other neighbours.
/// Must follow every change before the next question.
void forget(const mesh::Surface& s, const std::vector<int>& vertices, TurnSieve& sieve);

/// Whether triangle t is turned over.
bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t,
                    TurnSieve& sieve);

/// Whether one at v is.
bool is_turned_over_at(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                       TurnSieve& sieve);

/// Appends those at v that are.
void add_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                     TurnSieve& sieve, std::vector<int>& triangles);

}  // namespace tdbd::rock
