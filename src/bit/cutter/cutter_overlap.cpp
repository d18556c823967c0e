#include "bit/cutter/cutter_overlap.hpp"

#include "bit/cutter/cutter_gap.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/clip_convex.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit {
namespace {

constexpr double touching = 1e-6;     ///< m: cutters farther apart share no volume
constexpr double least_share = 1e-9;  ///< times a part's volume: less is rounding

/// A part of a cutter in the bit frame.
struct Piece {
  mesh::TriangleMesh surface;
  mesh::ConvexSolid solid;
};

std::vector<std::vector<Piece>> pieces_of(const Bit& bit) {
  std::vector<std::vector<Piece>> pieces(bit.cutters.size());
  for (const Part& part : bit.parts) {
    if (part.cutter < 0 || part.density <= 0.0) continue;
    mesh::TriangleMesh m = mesh_B(part);
    if (const auto solid = mesh::convex_solid(m))
      pieces[static_cast<std::size_t>(part.cutter)].push_back({std::move(m), *solid});
  }
  return pieces;
}

double common_volume(const Piece& a, const Piece& b) {
  if (!mesh::bounding_box(a.surface).overlaps(mesh::bounding_box(b.surface))) return 0.0;
  mesh::TriangleMesh m = a.surface;
  for (std::size_t i = 0; i < b.solid.planes && !m.triangles.empty(); ++i)
    m = mesh::clipped_convex(m, mesh::normal(b.solid, i), b.solid.b[i]);
  if (m.triangles.empty()) return 0.0;
  const double volume = mesh::enclosed_volume(m);
  return volume > least_share * mesh::enclosed_volume(a.surface) ? volume : 0.0;
}

}  // namespace

std::vector<CutterOverlap> cutter_overlaps(const Bit& bit) {
  const std::vector<std::vector<Piece>> pieces = pieces_of(bit);
  std::vector<CutterOverlap> overlaps;
  for (std::size_t a = 0; a < pieces.size(); ++a)
    for (std::size_t b = a + 1; b < pieces.size(); ++b) {
      if (!closer_than(bit.cutters[a], bit.cutters[b], touching)) continue;
      CutterOverlap o{static_cast<int>(a), static_cast<int>(b), 0.0};
      for (const Piece& of_a : pieces[a])
        for (const Piece& of_b : pieces[b]) o.volume += common_volume(of_a, of_b);
      if (o.volume > 0.0) overlaps.push_back(o);
    }
  return overlaps;
}

}  // namespace tdbd::bit
