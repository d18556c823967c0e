#include "mesh/repair/repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

#include "mesh/check/check.hpp"
#include "mesh/check/nesting.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/repair/repair_steps.hpp"

namespace tdbd::mesh {
namespace {

std::size_t equal_points(const TriangleMesh& m) {
  std::set<std::array<double, 3>> places;
  for (const Vec3& x : m.positions) places.insert({x.x(), x.y(), x.z()});
  return m.positions.size() - places.size();
}

std::size_t duplicates(const TriangleMesh& m) {
  std::set<Triangle> corners;
  for (Triangle t : m.triangles) {
    std::sort(t.begin(), t.end());
    corners.insert(t);
  }
  return m.triangles.size() - corners.size();
}

void measure_edges(const TriangleMesh& m, const std::vector<Side>& sides, Inspection& found) {
  std::size_t edges = 0;
  found.shortest_edge = std::numeric_limits<double>::infinity();
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    const double length = (position(m, first->hi) - position(m, first->lo)).norm();
    found.shortest_edge = std::min(found.shortest_edge, length);
    found.longest_edge = std::max(found.longest_edge, length);
    found.mean_edge += length;
    ++edges;
    found.open_edges += last - first == 1;
    found.non_manifold_edges += last - first > 2;
    found.flipped_edges += last - first == 2 && first[0].forward == first[1].forward;
  });
  found.mean_edge /= static_cast<double>(std::max<std::size_t>(edges, 1));
}

}  // namespace

Inspection inspect(const TriangleMesh& m) {
  Inspection found;
  found.vertices = m.positions.size();
  found.facets = m.triangles.size();
  found.equal_points = equal_points(m);
  found.duplicates = duplicates(m);
  const std::vector<Side> sides = sorted_sides(m);
  measure_edges(m, sides, found);
  found.pieces = connected_pieces(m.triangles).size();
  const std::vector<int> fans = fan_counts(m, sides);
  found.non_manifold_vertices = static_cast<std::size_t>(
      std::count_if(fans.begin(), fans.end(), [](int n) { return n > 1; }));
  found.worst_quality = 1.0;
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const auto [a, b, c] = corners(m, i);
    const double q = triangle_quality(a, b, c);
    found.worst_quality = std::min(found.worst_quality, q);
    found.degenerate += q < degenerate_quality;
  }
  found.intersecting_pairs = self_intersections(m).size();
  found.volume = enclosed_volume(m);
  found.area = area(m);
  found.box = bounding_box(m);
  return found;
}

namespace {

/// Quotes a word for a shell command line if necessary.
std::string shell_quoted(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./+,:@%";
  if (word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Whether a repair is tried only to improve the message. The time to fill a hole grows at least
/// with the square of the number of its edges; it is 0.25 s at this limit.
bool repair_is_fast(const std::vector<Defect>& defects) {
  constexpr long most_open_edges = 1000;
  return std::ranges::count(defects, Defect::Kind::hole, &Defect::kind) <= most_open_edges;
}

/// What the user can do about the defects, or why no repair is possible.
enum class Trial { all, some };
std::string advice(const std::filesystem::path& path, Trial trial, const std::string& refusal) {
  if (!refusal.empty())
    return fmt::format("{}: tdbd mesh --repair cannot repair this: {}", path.string(),
                       refusal.substr(0, refusal.find('\n')));
  return fmt::format("{}: to {}: {}", path.string(),
                     trial == Trial::all ? "repair" : "try a repair", repair_command(path, ""));
}

void record(Repaired& r, std::size_t count, const std::string& what) {
  if (count > 0) r.steps.push_back({what, count});
}

/// What a repair must preserve.
struct Extent {
  double volume = 0.0;  ///< m3, signed; of an open mesh, the same sum over its facets
  double area = 0.0;    ///< m2
  Box box;
};

Extent extent_of(const TriangleMesh& m) { return {enclosed_volume(m), area(m), bounding_box(m)}; }

/// Describes a change beyond most_changed: "its volume from 1000 to 970 mm3 (-3.0 %)". Changes below
/// `floor` are rounding.
std::string change(const char* what, const char* unit, double before, double after, double floor) {
  const double by = after - before;
  if (std::abs(by) <= std::max(most_changed * std::abs(before), floor)) return "";
  return fmt::format(", its {} from {:.6g} to {:.6g} {} ({:+.3g} %)", what, before, after, unit,
                     100.0 * by / std::abs(before));
}

/// Why a step is refused: it changed the mesh by more than it may. Empty if it did not.
std::string loss(const char* step, const Extent& before, const Extent& after) {
  constexpr double rounding = 1e-6;
  const Vec3 old_size = 1e3 * before.box.size(), size = 1e3 * after.box.size();  // mm
  const double area = 1e6 * before.area, across = old_size.norm();
  std::string text =
      change("volume", "mm3", 1e9 * before.volume, 1e9 * after.volume, rounding * area * across);
  text += change("area", "mm2", area, 1e6 * after.area, rounding * area);
  constexpr std::array sides = {"size along x", "size along y", "size along z"};
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    text += change(sides[k], "mm", old_size[axis], size[axis], rounding * across);
  }
  if (text.empty()) return "";
  return fmt::format("{} would change {}; at most {:.3g} % are permitted", step, text.substr(2),
                     100.0 * most_changed);
}

/// Compares a union with its bodies: it may be smaller than their sum where they overlap, but not
/// smaller than any of them, and has the box of all.
std::string loss_of_union(const TriangleMesh& before, const TriangleMesh& after) {
  Extent expected = extent_of(before);
  const Extent now = extent_of(after);
  double largest = 0.0;
  for (const TriangleMesh& body : submeshes(before, facets_of_bodies(before)))
    largest = std::max(largest, enclosed_volume(body));
  expected.volume = std::clamp(now.volume, std::min(largest, expected.volume), expected.volume);
  expected.area = std::min(now.area, expected.area);
  return loss("uniting the pieces", expected, now);
}

/// Performs the steps that do not need a closed mesh.
void repair_facets(Repaired& r, const RepairOptions& options) {
  TriangleMesh& m = r.mesh;
  TriangleMesh distinct = m;
  merge_points(distinct, 0.0);
  drop_duplicates(distinct);
  const Extent before = extent_of(distinct);
  record(r, merge_points(m, options.weld),
         options.weld > 0.0
             ? fmt::format("points merged with another within {:.6g} mm", 1e3 * options.weld)
             : "points merged at equal places");
  record(r, drop_duplicates(m), "duplicate facets dropped");
  record(r, remove_degenerate(m), "facets without area removed");
  record(r, split_t_junctions(m, options.weld),
         "corners inserted into edges on which they lie (T-junctions)");
  if (m.triangles.empty()) r.refusal = "no facet is left";
  if (r.refusal.empty()) r.refusal = loss("merging points", before, extent_of(m));
  if (!r.refusal.empty()) return;
  record(r, drop_sheets(m), "facets of protruding sheets dropped");
  record(r, drop_unused_points(m), "unused points dropped");
}

/// Performs all steps except the removal of intersections. Stops at the first refusal.
void repair_surface(Repaired& r, const RepairOptions& options) {
  TriangleMesh& m = r.mesh;
  repair_facets(r, options);
  if (!r.refusal.empty()) return;
  record(r, split_non_manifold(m, r.refusal),
         "points duplicated where more than two facets met at an edge, or fans at a point");
  if (!r.refusal.empty()) return;
  record(r, orient_facets(m, r.refusal), "facets flipped to agree with their neighbours");
  if (!r.refusal.empty()) return;
  record(r, fill_holes(m, r.refusal), "holes filled");
  if (!r.refusal.empty()) return;
  record(r, orient_pieces(m), "facets flipped to orient pieces outwards");
  record(r, drop_inner_shells(m),
         "facets dropped of shells that lie inside another one and bound nothing: to make them "
         "cavities, reverse their facets");
}

void repair_intersections(Repaired& r) {
  const std::size_t pairs = self_intersections(r.mesh).size();
  if (pairs == 0) return;
  TriangleMesh changed = r.mesh;
  if (unite_pieces(changed)) {
    r.refusal = loss_of_union(r.mesh, changed);
  } else if (changed = r.mesh; remesh_intersections(changed)) {
    r.refusal = loss("remeshing around intersections", extent_of(r.mesh), extent_of(changed));
  } else {
    r.refusal = fmt::format("{} pairs of facets intersect and could not be removed", pairs);
  }
  if (!r.refusal.empty()) return;
  r.mesh = std::move(changed);
  record(r, pairs, "intersecting pairs of facets removed by uniting pieces or remeshing");
}

}  // namespace

Repaired repair(TriangleMesh m, const RepairOptions& options) {
  Repaired r{std::move(m), {}, {}};
  if (options.weld == 0.0 && check_solid(r.mesh).empty()) return r;
  repair_surface(r, options);
  if (r.refusal.empty() && r.mesh.triangles.empty()) r.refusal = "no facet is left";
  if (r.refusal.empty()) repair_intersections(r);
  if (!r.refusal.empty()) return r;
  if (const auto left = check_solid(r.mesh); !left.empty()) r.refusal = summarize(left);
  return r;
}

std::string repair_command(const std::filesystem::path& path, const std::string& weld) {
  std::filesystem::path out = path;
  out.replace_filename(path.stem().string() + "-repaired" + path.extension().string());
  return fmt::format("tdbd mesh {} --repair{} -o {}", shell_quoted(path.string()),
                     weld.empty() ? "" : " --weld " + shell_quoted(weld),
                     shell_quoted(out.string()));
}

std::optional<WeldHint> crack_hint(const std::vector<Solid>& solids) {
  std::vector<const Solid*> open;
  for (const Solid& solid : solids)
    if (open_edges(solid.mesh) > 0) open.push_back(&solid);
  if (open.empty()) return std::nullopt;
  return 2 * open.size() > solids.size() ? weld_hint(merged(solids)) : weld_hint(open[0]->mesh);
}

namespace {

/// Tries a repair to find out whether it is possible.
std::string advice_from_trials(const std::filesystem::path& path,
                               const std::vector<const Solid*>& faulty) {
  constexpr std::size_t most_trials = 12;
  std::string refusal;
  Trial trial = faulty.size() > most_trials ? Trial::some : Trial::all;
  for (std::size_t i = 0; i < std::min(most_trials, faulty.size()); ++i)
    if (!repair_is_fast(check_solid(faulty[i]->mesh)))
      trial = Trial::some;
    else if (refusal.empty())
      refusal = repair(faulty[i]->mesh).refusal;
  return advice(path, trial, refusal);
}

}  // namespace

std::vector<std::string> mesh_faults(const std::filesystem::path& path,
                                     const std::vector<Solid>& solids) {
  constexpr std::size_t most_lines = 12;
  std::vector<std::string> lines;
  std::vector<const Solid*> faulty;
  std::size_t more = 0;
  for (const Solid& solid : solids) {
    const auto defects = check_solid(solid.mesh);
    if (defects.empty()) continue;
    faulty.push_back(&solid);
    std::istringstream text(summarize(defects));
    for (std::string line; std::getline(text, line);)
      if (lines.size() < most_lines)
        lines.push_back(fmt::format("{}: solid {}: {}", path.string(), solid.name, line));
      else
        ++more;
  }
  if (lines.empty()) return lines;
  if (more > 0) lines.push_back(fmt::format("{}: and {} more", path.string(), more));
  if (const auto hint = crack_hint(solids)) {
    lines.push_back(fmt::format("{}: {}", path.string(), describe(*hint)));
    lines.push_back(
        fmt::format("{}: to repair: {}", path.string(), repair_command(path, weld_text(*hint))));
  } else {
    lines.push_back(advice_from_trials(path, faulty));
  }
  return lines;
}

}  // namespace tdbd::mesh
