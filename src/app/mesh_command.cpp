#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/arguments.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/grade/grade.hpp"
#include "mesh/repair/repair.hpp"
#include "simulation/start/rock_start.hpp"

namespace tdbd::app {
namespace {

namespace fs = std::filesystem;
using mesh::Solid;

struct MeshChoices {
  std::string file, output, only = "*", weld = "0 mm";
  std::string unit;  ///< empty: 1 mm, or 1 m for a rock written by a run
  std::string edge = "0.5 mm", face = "3 mm", angle = "25 deg", deviation = "0.005 mm";
  double growth = 0.5;
  bool repair = false, grade = false, force = false;
};

double length(const std::string& option, const std::string& text) {
  return option_quantity(option, text, "m", Range::non_negative(), "a length");
}

const char* yes_or_no(bool is) { return is ? "yes" : "no"; }

void print_row(const Solid& solid) {
  const mesh::Inspection i = mesh::inspect(solid.mesh);
  const Vec3 size = 1e3 * i.box.size();
  print_out(
      "{:<24} {:>8} {:>8} {:>6} {:>6} {:>8} {:>8} {:>13.3f} {:>9.3f} {:>9.3f} {:>9.3f} {:>8.4f} "
      "{:>8.4f} {:>8.4f} {:>7.4f} {:>5}\n",
      solid.name, i.vertices, i.facets, i.pieces, yes_or_no(i.is_closed()),
      yes_or_no(i.is_oriented()), yes_or_no(i.is_manifold()), 1e9 * i.volume, size.x(), size.y(),
      size.z(), 1e3 * i.shortest_edge, 1e3 * i.mean_edge, 1e3 * i.longest_edge, i.worst_quality,
      i.intersecting_pairs);
}

void print_table(const std::vector<Solid>& solids) {
  print_out(
      "{:<24} {:>8} {:>8} {:>6} {:>6} {:>8} {:>8} {:>13} {:>9} {:>9} {:>9} {:>8} {:>8} {:>8} {:>7} "
      "{:>5}\n",
      "solid", "vertices", "facets", "pieces", "closed", "oriented", "manifold", "volume mm3",
      "box x mm", "y mm", "z mm", "edge mm", "mean", "longest", "quality", "cross");
  for (const Solid& solid : solids) print_row(solid);
}

void require_sound(const MeshChoices& choices, const std::vector<Solid>& solids) {
  std::string text;
  for (const std::string& line : mesh::mesh_faults(choices.file, solids))
    text += (text.empty() ? "" : "\n") + line;
  if (!text.empty()) throw InputError(text);
}

/// Prints the table, and rejects solids that are unsuitable for a bit. The rock of a run is an open
/// sheet and therefore not checked.
int inspect(const MeshChoices& choices, const std::vector<Solid>& solids) {
  print_table(solids);
  if (const auto stamp = simulation::read_stamp(choices.file))
    print_out(
        "the rock of a run after {} steps, t = {:.6g} s: a sheet, which bounds no volume; its file "
        "is in metres\n",
        stamp->step, stamp->time);
  else
    require_sound(choices, solids);
  return 0;
}

void require_output(const MeshChoices& choices) {
  const std::string& out = choices.output;
  if (out.empty()) throw InputError("--output: found no file, expected one: -o FILE");
  if (!fs::exists(out)) return;
  if (fs::equivalent(out, choices.file))
    throw InputError(out + ": found the input itself, expected another file to write");
  if (!choices.force) throw InputError(out + ": exists; --force replaces it");
}

int repair(const MeshChoices& choices, std::vector<Solid> solids) {
  const mesh::RepairOptions options{length("--weld", choices.weld)};
  std::string refusals;
  for (Solid& solid : solids) {
    mesh::Repaired r = mesh::repair(solid.mesh, options);
    for (const mesh::RepairStep& step : r.steps)
      print_out("{}: {} {}\n", solid.name, step.count, step.what);
    if (!r.refusal.empty())
      refusals += fmt::format("{}{}: solid {}: cannot be repaired: {}",
                              refusals.empty() ? "" : "\n", choices.file, solid.name, r.refusal);
    solid.mesh = std::move(r.mesh);
  }
  if (!refusals.empty()) throw InputError(refusals);
  mesh::write_in_unit_of(choices.output, solids, choices.file, length("--unit", choices.unit));
  print_table(solids);
  return 0;
}

mesh::GradeOptions grade_options(const MeshChoices& choices) {
  mesh::GradeOptions o;
  o.edge = length("--edge", choices.edge);
  o.face = length("--face", choices.face);
  o.deviation = length("--deviation", choices.deviation);
  o.angle = option_quantity("--angle", choices.angle, "rad", Range::non_negative(), "an angle");
  o.growth = choices.growth;
  if (!(o.edge > 0.0)) throw InputError("--edge: found no length, expected one like '0.5 mm'");
  if (o.face < o.edge)
    throw InputError(
        fmt::format("--face: found {}, expected at least --edge, {}", choices.face, choices.edge));
  if (!(o.growth >= 0.0))
    throw InputError(fmt::format("--growth: found {}, expected a number >= 0", o.growth));
  return o;
}

int grade(const MeshChoices& choices, std::vector<Solid> solids) {
  const mesh::GradeOptions options = grade_options(choices);
  for (Solid& solid : solids) {
    if (!fits(choices.only, solid.name)) continue;
    const std::size_t before = solid.mesh.triangles.size();
    mesh::Graded g = mesh::grade(solid.mesh, options);
    print_out(
        "{}: {} facets to {}, {} feature edges, surface moved by {:.3g} mm at most, volume "
        "changed by {:.3g} mm3\n",
        solid.name, before, g.mesh.triangles.size(), g.feature_edges, 1e3 * g.deviation,
        1e9 * g.volume_change);
    solid.mesh = std::move(g.mesh);
  }
  mesh::write_in_unit_of(choices.output, solids, choices.file, length("--unit", choices.unit));
  print_table(solids);
  return 0;
}

int inspect_or_write(MeshChoices choices) {
  if (choices.unit.empty()) choices.unit = simulation::read_stamp(choices.file) ? "1 m" : "1 mm";
  const double unit = length("--unit", choices.unit);
  if (!(unit > 0.0)) throw InputError("--unit: found no length, expected one like '1 mm'");
  if (choices.repair && choices.grade)
    throw InputError("--grade: found --repair as well, expected one of them at a time");
  if (choices.repair || choices.grade) require_output(choices);
  std::vector<Solid> solids = mesh::read_solids(choices.file, unit);
  if (choices.repair) return repair(choices, std::move(solids));
  if (!choices.grade) return inspect(choices, solids);
  require_sound(choices, solids);
  return grade(choices, std::move(solids));
}

}  // namespace

void add_mesh(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("mesh", "Inspect a mesh file; repair or grade it into another one");
  auto choices = std::make_shared<MeshChoices>();
  command->add_option("mesh", choices->file, "the mesh file (STL, OBJ, PLY or OFF)")
      ->required()
      ->type_name(a_mesh_file);
  command->add_option("--unit", choices->unit,
                      "length unit of the file; default: 1 mm, or 1 m for the rock of a run");
  command->add_flag("--repair", choices->repair,
                    "repair the solids so that they are closed and face outward; requires -o");
  command->add_option("--weld", choices->weld, "a repair merges points up to this far apart")
      ->capture_default_str();
  command->add_flag("--grade", choices->grade,
                    "refine along sharp edges, coarsen flat and smooth faces; requires -o");
  command->add_option("--only", choices->only, "names of the solids to grade; * matches any text")
      ->capture_default_str();
  command->add_option("--edge", choices->edge, "target edge length at sharp edges")
      ->capture_default_str();
  command->add_option("--face", choices->face, "target edge length far from sharp edges")
      ->capture_default_str();
  command
      ->add_option("--growth", choices->growth,
                   "growth of the target length per length of distance")
      ->capture_default_str();
  command->add_option("--angle", choices->angle, "smallest angle between facets at a sharp edge")
      ->capture_default_str();
  command
      ->add_option("--deviation", choices->deviation, "largest permitted movement of the surface")
      ->capture_default_str();
  command
      ->add_option("-o,--output", choices->output,
                   "the file to write, in the format of its extension; the input is not changed")
      ->type_name(a_mesh_file);
  command->add_flag("--force", choices->force, "replace the output file");
  command->footer("Example: tdbd mesh bit.stl --repair -o bit-repaired.stl");
  command->callback(
      [choices, &exit_code] { exit_code = guarded([&] { return inspect_or_write(*choices); }); });
}

}  // namespace tdbd::app
