#pragma once

#include <cstddef>
#include <cstring>

namespace tdbd {

/// Single precision, used to reject candidates conservatively with a margin for its rounding, and
/// where a file format requires it. No result is computed in it. It needs half the memory of double
/// and has twice the lanes.
using Single = float;

}  // namespace tdbd

/// Compiles a function over columns for wider vector registers as well; the version is chosen when
/// the program starts. Operations are neither contracted nor reordered, so the results of both
/// versions are bitwise identical.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && defined(__OPTIMIZE__)
#define TDBD_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define TDBD_WIDE
#endif

/// For functions that take or change Wides by reference and are called by TDBD_WIDE functions: they
/// must be inlined into each version.
#define TDBD_INLINE [[gnu::always_inline]] inline

namespace tdbd {

/// Columns that wide loops read are padded to a multiple of this.
inline constexpr std::size_t lanes = 4;

/// `lanes` doubles as one value. Arithmetic, comparison and ?: apply to each lane.
using Wide = double __attribute__((vector_size(lanes * sizeof(double))));

/// Result of a comparison of Wides. In each lane all bits are set, or none.
using WideMask = decltype(Wide{} < Wide{});

/// `lanes` 64-bit integers.
using WideLong = long long __attribute__((vector_size(lanes * sizeof(long long))));

/// Single-precision counterparts with twice the lanes: values, and the result of a comparison (in
/// each lane all bits are set, or none).
inline constexpr std::size_t single_lanes = 8;
using WideSingle = Single __attribute__((vector_size(single_lanes * sizeof(Single))));
using WideFlags = int __attribute__((vector_size(single_lanes * sizeof(int))));

/// Load and store. No function takes or returns a Wide by value, because instruction sets pass them
/// differently.
#define TDBD_LOAD(wide, address) std::memcpy(&(wide), (address), sizeof(wide))
#define TDBD_STORE(wide, address) std::memcpy((address), &(wide), sizeof(wide))

/// Whether any flag is set.
inline bool any_of(const WideFlags& flags) {
  using Halves = long long __attribute__((vector_size(sizeof(WideFlags))));
  Halves halves;
  TDBD_LOAD(halves, &flags);
  return (halves[0] | halves[1] | halves[2] | halves[3]) != 0;
}

/// Bit l is set if lane l is.
TDBD_INLINE unsigned lane_bits(const WideMask& m) {
  return static_cast<unsigned>((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8));
}

/// Bit l is set if flag l is.
inline unsigned bits_of(const WideFlags& flags) {
  const WideFlags b = flags & WideFlags{1, 2, 4, 8, 16, 32, 64, 128};
  return static_cast<unsigned>(b[0] | b[1] | b[2] | b[3] | b[4] | b[5] | b[6] | b[7]);
}

}  // namespace tdbd
