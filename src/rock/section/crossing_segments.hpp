#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rock/rock.hpp"
#include "rock/section/column_sums.hpp"

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

/// The columns of a face, carried to some place, and the zone around them in which to search for
/// rock.
struct FacePlane {
  Vec3 n_W, y_W, z_W;  ///< axes of F in W; n points into the rock ahead
  double n0, y0, z0;   ///< m, coordinates of F's origin along them
  const FaceColumns& face;
  double left, right;  ///< m, y of the ends of the columns
  double reach;        ///< m
  double top;          ///< m, largest z of start vertices
  int near_list;       ///< index of the rock's list that may cover the zone; -1: none

  double ahead(const Vec3& x_W) const { return dot(n_W, x_W) - n0; }
  Vec2 in_plane(const Vec3& x_W) const { return {dot(y_W, x_W) - y0, dot(z_W, x_W) - z0}; }

 private:
  /// Scalar code, because three numbers take less time than one and a half packets.
  static double dot(const Vec3& n, const Vec3& x) {
    return n.x() * x.x() + n.y() * x.y() + n.z() * x.z();
  }
};

FacePlane face_plane(const Pose& X_WF, const FaceColumns& face, std::size_t first, std::size_t end,
                     double reach, double top, int near_list);

/// Location of a point of the outline. `inside`: inside the columns, away from their edges.
/// `beneath`: not above the line of the lower edge of a column beside it or nearby. Otherwise
/// `anywhere`.
enum class PointPlace : std::uint8_t { anywhere, inside, beneath };

struct PlacedPoint {
  PointPlace place;
  const FaceColumn* column;  ///< beside the point; may be null if the point is inside
};

/// Points of the outline from `first` to before `end`, at least two, with rock on their left.
struct OutlineRun {
  std::size_t first, end;
};

/// Buffers for the segments of the rock's outline.
struct OutlineWork {
  std::vector<int> chains;
  std::vector<int> near;     ///< start vertices
  std::vector<double> y, z;  ///< m, coordinates of the points in the plane of F
  std::vector<PlacedPoint> place;
  std::vector<OutlineRun> runs;
  CrossedEdges crossed;  ///< for the current plane: edges at which a segment begins
};

/// Finds where the rock's triangles cross the plane of a face beside some of its columns, and
/// stores it in work.runs. Each triangle gives one segment, between consecutive points of a run.
/// Runs may be in any order and begin anywhere. Corners in the plane count as ahead of it. The zone
/// is the region within `reach` of the columns' ends and lower edges. An outline within the zone is
/// found completely if one of its triangles there has a start vertex: in the zone, not above `top`,
/// not below the face's box by more than `reach`, and ahead of the plane by at most `reach`. From
/// start vertices the outline is followed from triangle to triangle, whatever the length of their
/// edges.
void find_outline(const Rock& rock, const FacePlane& plane, OutlineWork& work);

/// Whether the segment from point k to point k + 1 is beneath the face, so that no part of the face
/// lies below it. Conservative: may return false for such a segment.
bool is_beneath(const OutlineWork& work, std::size_t k);

}  // namespace tdbd::rock
