#pragma once

#include <cstddef>
#include <cstring>

#include "core/single.hpp"

/// Marks a function over columns to be compiled for wider vector registers too; the program picks
/// when it starts. No operation is contracted or reordered, so either choice gives the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && defined(__OPTIMIZE__)
#define TDBD_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define TDBD_WIDE
#endif

namespace tdbd {

/// Columns that wide loops read are padded to a multiple of this.
inline constexpr std::size_t lanes = 4;

/// `lanes` numbers that are computed with as one: arithmetic, comparison and ?: work on each.
using Wide = double __attribute__((vector_size(lanes * sizeof(double))));

/// The same of single precision, twice as many, and what comparing them gives: all bits or none.
inline constexpr std::size_t single_lanes = 8;
using WideSingle = Single __attribute__((vector_size(single_lanes * sizeof(Single))));
using WideFlags = int __attribute__((vector_size(single_lanes * sizeof(int))));

/// No function takes or returns a Wide: how one is passed differs between instruction sets.
#define TDBD_LOAD(wide, address) std::memcpy(&(wide), (address), sizeof(wide))
#define TDBD_STORE(wide, address) std::memcpy((address), &(wide), sizeof(wide))

/// Whether any flag is set. Passed by reference, see above; meant to be inlined.
inline bool any_of(const WideFlags& flags) {
  using Halves = long long __attribute__((vector_size(sizeof(WideFlags))));
  Halves halves;
  TDBD_LOAD(halves, &flags);
  return (halves[0] | halves[1] | halves[2] | halves[3]) != 0;
}

/// Bit l: whether flag l is set. Passed by reference, see above; meant to be inlined.
inline unsigned bits_of(const WideFlags& flags) {
  const WideFlags b = flags & WideFlags{1, 2, 4, 8, 16, 32, 64, 128};
  return static_cast<unsigned>(b[0] | b[1] | b[2] | b[3] | b[4] | b[5] | b[6] | b[7]);
}

}  // namespace tdbd
