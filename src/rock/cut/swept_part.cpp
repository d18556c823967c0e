#include "rock/cut/swept_part.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "mesh/search/triangle_tree.hpp"

namespace tdbd::rock {
namespace {

/// State of the search for the largest exit. The exit through one plane is a monotonic function of
/// tau, so the smallest of them, the way out, has one maximum ("top"). `in` is a place on the
/// solid, before the top as seen along `side`. `out` is beyond the top or misses the solid: because
/// the ray enters plane `entered` too late, or because it leaves before t = 0.
struct Search {
  Crossing in, out;
  double side;
  std::size_t entered;
};
constexpr std::size_t no_plane = std::numeric_limits<std::size_t>::max();

/// Distance of x outside plane i.
double distance_beyond(const PlaneStrip& w, std::size_t i, const Crossing& x) {
  return w.along[i] * x.tau + (w.up[i] + w.twist[i] * x.tau) * x.t - w.rest[i];
}

/// Whether rays between `in` and `out` may miss the solid.
bool may_miss(const Search& s) { return s.entered != no_plane || s.out.t < 0.0; }

/// Distance of tau from `in` towards `out`; infinite if tau is not between them.
double way_to(const Search& s, double tau) {
  const double way = s.side * (tau - s.in.tau);
  return way >= 0.0 && s.side * (s.out.tau - tau) >= 0.0 ? way
                                                         : std::numeric_limits<double>::infinity();
}

/// Returns the tau at which planes k and l meet between `in` and `out`: the root of a nearly linear
/// quadratic whose coefficients depend on the planes alone. If rounding hides the root, returns the
/// end of the interval that is nearer to it.
double meeting(const PlaneStrip& w, std::size_t k, std::size_t l, const Search& s) {
  const double square = w.along[l] * w.twist[k] - w.along[k] * w.twist[l];
  const double slope =
      w.rest[k] * w.twist[l] - w.rest[l] * w.twist[k] + w.along[l] * w.up[k] - w.along[k] * w.up[l];
  const double at_zero = w.rest[k] * w.up[l] - w.rest[l] * w.up[k];
  const double root = std::sqrt(std::max(0.0, slope * slope - 4.0 * square * at_zero));
  const double below = slope + std::copysign(root, slope);
  if (below == 0.0) return s.in.tau;
  const double near = -2.0 * at_zero / below, far = -0.5 * below / square;
  const double tau = way_to(s, far) < way_to(s, near) ? far : near;
  return std::clamp(tau, std::min(s.in.tau, s.out.tau), std::max(s.in.tau, s.out.tau));
}

/// Growth with tau of the exit through this plane; only the sign is meaningful.
double rise(const PlaneStrip& w, const Crossing& x) {
  return -(w.along[x.plane] + x.t * w.twist[x.plane]);
}

/// The plane that the ray enters too late to meet the solid, or no_plane. Entries before t = 0 do
/// not count.
std::size_t entered_too_late(const PlaneStrip& w, const Crossing& x) {
  if (x.t < 0.0) return no_plane;
  const Crossing last = enter_at(w, x.tau);
  return last.t <= x.t + entry_tolerance ? no_plane : last.plane;
}

/// The plane other than `known` that x lies farthest outside of; no_plane if x is outside no other
/// plane.
std::size_t farthest_beyond(const PlaneStrip& w, const Crossing& x, std::size_t known) {
  double most = corner_tolerance;
  std::size_t farthest = no_plane;
  for (std::size_t i = 0; i < w.columns; ++i) {
    const double beyond = distance_beyond(w, i, x);
    if (i == known || !(beyond > most)) continue;
    most = beyond;
    farthest = i;
  }
  return farthest;
}

/// Why a tau is examined. `top`: the ways out of `in` and `out` meet there. `end`: the solid ends
/// there, where the way out of `out` meets plane `entered`. `middle`: bisection.
enum class Look { top, end, middle };

/// Whether the two planes of the look meet at x. They may also meet where the ray has left a third
/// plane before.
bool is_corner(const PlaneStrip& w, const Search& s, Look look, const Crossing& x) {
  if (look == Look::middle) return false;
  const std::size_t other = look == Look::end ? s.entered : s.in.plane;
  return std::abs(distance_beyond(w, s.out.plane, x)) <= corner_tolerance &&
         std::abs(distance_beyond(w, other, x)) <= corner_tolerance;
}

/// The tau nearest to `in` at which two planes of the search meet. The top is not beyond any of
/// these that is a corner.
double next_tau(const PlaneStrip& w, const Search& s, Look& look) {
  const bool has_end = s.entered != no_plane;
  look = has_end ? Look::end : Look::top;
  const double end = has_end ? meeting(w, s.out.plane, s.entered, s) : s.out.tau;
  if (s.out.t >= 0.0 && s.side * rise(w, s.out) >= 0.0) return end;
  const double top = meeting(w, s.in.plane, s.out.plane, s);
  if (has_end && s.side * (top - end) >= 0.0) return end;
  look = Look::top;
  return top;
}

/// Updates the search with the exit at a new tau. Returns whether it is the top.
bool narrow(const PlaneStrip& w, const Crossing& x, Look look, Search& s) {
  const bool same_plane = x.plane == s.out.plane, corner = is_corner(w, s, look, x);
  std::size_t too_late = may_miss(s) ? entered_too_late(w, x) : no_plane;
  if (too_late != no_plane) {
    if (corner && same_plane && too_late == s.entered) {  // the end of the solid, up to rounding
      too_late = farthest_beyond(w, x, s.entered);
      if (too_late == no_plane) return true;
    }
    s.out = x;
    s.entered = too_late;
    return false;
  }
  const double growth = x.t < 0.0 ? -1.0 : s.side * rise(w, x);
  if (growth == 0.0) return true;
  if (corner && same_plane && (look == Look::end || growth < 0.0)) return true;
  if (corner && growth > 0.0 && x.plane == s.in.plane && look == Look::top) return true;
  if (growth > 0.0) {
    s.in = x;
  } else {
    s.out = x;
    s.entered = no_plane;
  }
  return false;
}

Crossing highest(const PlaneStrip& w, Search& s, double t_max) {
  if (!may_miss(s) && s.side * rise(w, s.out) >= 0.0) return s.out;
  constexpr int most_probes = 64;  // each look finds a new plane; usually one or two are enough
  for (int k = 0; k < most_probes; ++k) {
    Look look{};
    double tau = next_tau(w, s, look);
    if (tau == s.in.tau && is_corner(w, s, look, s.in)) return s.in;
    if (tau == s.in.tau || (tau == s.out.tau && !is_corner(w, s, look, s.out))) {
      look = Look::middle;
      tau = 0.5 * (s.in.tau + s.out.tau);
    }
    const Crossing x = leave_at(w, tau);
    if (!(x.t < t_max) || narrow(w, x, look, s)) return x;
  }
  return s.in;
}

}  // namespace

double depth_inside(const mesh::ConvexSolid& s, const Vec3& x_P) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < s.b.size(); ++i)
    depth = std::min(depth, s.b[i] - (s.nx[i] * x_P.x() + s.ny[i] * x_P.y() + s.nz[i] * x_P.z()));
  return depth;
}

bool is_swept(const mesh::ConvexSolid& solid, const RelativePath& path, double depth) {
  PlaneStrip strip;
  const Interval inside = put_path_on_strip(solid, path, depth, strip);
  return inside.lo < inside.hi;
}

std::optional<Crossing> find_exit(const mesh::ConvexSolid& solid, const RelativePath& path,
                                  double depth, PlaneStrip& strip, double t_max) {
  const Interval inside = put_path_on_strip(solid, path, depth, strip);
  if (inside.lo >= inside.hi) return std::nullopt;
  put_direction_on_strip(solid, path, strip);
  const bool from_start = inside.lo == 0.0, to_end = inside.hi == 1.0;
  const double middle = 0.5 * (inside.lo + inside.hi);
  const Crossing in = leave_at(strip, to_end ? 1.0 : from_start ? 0.0 : middle);
  const double growth = in.t < t_max ? rise(strip, in) : 0.0;
  const double end = growth > 0.0 ? 1.0 : 0.0;
  if (growth == 0.0 || in.tau == end) return in;
  Search s{in, leave_at(strip, end), growth > 0.0 ? 1.0 : -1.0, no_plane};
  if (!(s.out.t < t_max)) return s.out;
  if (!(growth > 0.0 ? to_end : from_start)) s.entered = entered_too_late(strip, s.out);
  return highest(strip, s, t_max);
}

std::optional<double> exit_distance(const mesh::ConvexSolid& solid, const RelativePath& path,
                                    double depth, PlaneStrip& strip) {
  const auto x = find_exit(solid, path, depth, strip);
  if (!x) return std::nullopt;
  return std::max(0.0, x->t);
}

bool is_swept(const CuttingPart& part, const RelativePath& path, SweptScratch& scratch) {
  return part.tree_P ? is_swept(*part.tree_P, path, part.depth, scratch.mesh)
                     : is_swept(part.solid_P, path, part.depth);
}

std::optional<double> exit_distance(const CuttingPart& part, const RelativePath& path,
                                    SweptScratch& scratch) {
  if (part.tree_P) return exit_distance(*part.tree_P, path, part.depth, scratch.mesh);
  PlaneStrip strip;
  return exit_distance(part.solid_P, path, part.depth, strip);
}

void prepare_exits(const CuttingPart& part, const PathBoxes& boxes, SweptScratch& scratch) {
  if (part.tree_P) return;
  if (scratch.near.size() <= part.slot) scratch.near.resize(part.slot + 1);
  constexpr double usual_exit = 0.1;  // times the part's size; farther exits use all planes
  update_near_planes(part.solid_P, part.checksum, boxes, part.depth,
                     usual_exit * part.depth / tolerance::swept, scratch.near[part.slot]);
}

std::optional<Crossing> prepared_exit(const CuttingPart& part, const RelativePath& path,
                                      const SweptScratch& scratch) {
  const NearPlanes& near = scratch.near[part.slot];
  PlaneStrip strip;
  auto x = find_exit(near.solid_P, path, part.depth, strip, near.t_max);
  if (x && !(x->t < near.t_max)) return find_exit(part.solid_P, path, part.depth, strip);
  if (x) x->plane = near.plane[x->plane];
  return x;
}

std::optional<double> prepared_exit_distance(const CuttingPart& part, const RelativePath& path,
                                             SweptScratch& scratch) {
  if (part.tree_P) return exit_distance(part, path, scratch);
  const auto x = prepared_exit(part, path, scratch);
  return x ? std::optional(std::max(0.0, x->t)) : std::nullopt;
}

double depth_inside(const CuttingPart& part, const Vec3& x_P) {
  if (!part.tree_P) return depth_inside(part.solid_P, x_P);
  return mesh::inside(*part.tree_P, x_P) ? mesh::distance(*part.tree_P, x_P) : 0.0;
}

namespace {

Vec3 place_on_strip(const RelativePath& p, double tau, double t) {
  return p.q0_P + tau * (p.q1_P - p.q0_P) + t * (p.u0_P + tau * (p.u1_P - p.u0_P));
}

}  // namespace

std::optional<UnionExit> union_exit(const CuttingUnion& whole, const RelativePath& path,
                                    const Crossing& x) {
  if (x.t <= 0.0) return std::nullopt;
  const int owner = owner_at(whole.claims, x.plane, place_on_strip(path, x.tau, x.t));
  return UnionExit{at(owner), x.t};
}

std::optional<UnionExit> prepared_union_exit(const CuttingUnion& whole, const RelativePath& path,
                                             const SweptScratch& scratch) {
  const auto x = prepared_exit(whole.solid, path, scratch);
  return x ? union_exit(whole, path, *x) : std::nullopt;
}

}  // namespace tdbd::rock
