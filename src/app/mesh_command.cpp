#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/arguments.hpp"
#include "app/terminal.hpp"
#include "bit/files/file_checks.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "mesh/check/weld.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/files.hpp"
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
  std::string unit;         ///< empty: what the file states, otherwise 1 mm
  std::string output_unit;  ///< empty: see unit_of_output
  std::string edge = "0.5 mm", face = "3 mm", angle = "25 deg", deviation = "0.005 mm";
  double growth = 0.5;
  bool repair = false, grade = false, force = false, binary = false;
  bool sheet = false, flip = false, fill_holes = false, z_up = false;

  bool is_sheet() const { return sheet || flip || fill_holes || z_up; }
  bool writes() const { return repair || grade || flip || fill_holes || z_up || !output.empty(); }
};

/// The largest numbers of lines that are printed about solids, and about holes.
constexpr std::size_t most_rows = 10, most_holes = 12;

/// The usual longest side of a rock.
constexpr bit::SizeRange rock_along{"the rock of a case", 5e-3, 5.0};

double length(const std::string& option, const std::string& text) {
  return option_quantity(option, text, "m", Range::non_negative(), "a length");
}

mesh::LengthUnit unit_option(const std::string& option, const std::string& text) {
  try {
    return mesh::length_unit(text);
  } catch (const UnitError&) {
    throw InputError(
        fmt::format("{}: found '{}', expected a length unit like 'mm' or '1 mm'", option, text));
  }
}

/// The unit of the input. The rock of an earlier version of a run is in m, but states no unit.
mesh::LengthUnit unit_of_input(const MeshChoices& choices) {
  if (choices.unit.empty()) {
    if (auto stated = mesh::stated_unit_of(choices.file)) return *stated;
    return mesh::length_unit(simulation::read_stamp(choices.file) ? "m" : "mm");
  }
  mesh::LengthUnit unit = unit_option("--unit", choices.unit);
  if (const auto found = mesh::unit_contradiction(choices.file, unit.metres); !found.empty())
    throw InputError(
        fmt::format("--unit: found {}; expected the stated unit, or no --unit", found));
  return unit;
}

/// PLY files of TDBD are in m; the other formats are for CAD programs, which expect mm.
mesh::LengthUnit unit_of_output(const MeshChoices& choices, const mesh::LengthUnit& input) {
  if (!choices.output_unit.empty()) return unit_option("--output-unit", choices.output_unit);
  const auto is_ply = [](const std::string& file) { return mesh::lower_extension(file) == ".ply"; };
  return is_ply(choices.file) && !is_ply(choices.output) ? mesh::length_unit("mm") : input;
}

void write(const MeshChoices& choices, const std::vector<Solid>& solids) {
  const mesh::LengthUnit input = unit_of_input(choices), unit = unit_of_output(choices, input);
  const auto stl = choices.binary ? mesh::StlKind::binary : mesh::StlKind::text;
  mesh::write_like(choices.output, solids, {unit, stl}, choices.file, input.metres);
  print_out("wrote {} in {}\n", choices.output, unit.name);
}

/// A length as text in mm with four decimals, or in um if these would hide it.
std::string edge_text(double metres) {
  constexpr double visible = 0.01e-3;
  return metres > 0.0 && metres < visible ? fmt::format("{:.3g} um", 1e6 * metres)
                                          : fmt::format("{:.4f}", 1e3 * metres);
}

const char* yes_or_no(bool is) { return is ? "yes" : "no"; }

enum class Surface { solid, sheet };

/// A sheet bounds nothing, so it has no volume and no outside.
void print_row(const Solid& solid, Surface kind) {
  const mesh::Inspection i = mesh::inspect(solid.mesh);
  const Vec3 size = 1e3 * i.box.size();
  const bool bounds = kind == Surface::solid;
  print_out(
      "{:<24} {:>8} {:>8} {:>6} {:>6} {:>8} {:>8} {:>13} {:>9.3f} {:>9.3f} {:>9.3f} {:>8} "
      "{:>8} {:>8} {:>7.4f} {:>5}\n",
      solid.name, i.vertices, i.facets, i.pieces, bounds ? yes_or_no(i.is_closed()) : "-",
      bounds ? yes_or_no(i.is_oriented()) : "-", yes_or_no(i.is_manifold()),
      bounds ? fmt::format("{:.3f}", 1e9 * i.volume) : "-", size.x(), size.y(), size.z(),
      edge_text(i.shortest_edge), edge_text(i.mean_edge), edge_text(i.longest_edge),
      i.worst_quality, i.intersecting_pairs);
}

void print_table(const std::vector<Solid>& solids, Surface kind = Surface::solid) {
  print_out(
      "{:<24} {:>8} {:>8} {:>6} {:>6} {:>8} {:>8} {:>13} {:>9} {:>9} {:>9} {:>8} {:>8} {:>8} {:>7} "
      "{:>5}\n",
      "solid", "vertices", "facets", "pieces", "closed", "oriented", "manifold", "volume mm3",
      "box x mm", "y mm", "z mm", "edge mm", "mean", "longest", "quality", "cross");
  for (std::size_t i = 0; i < std::min(most_rows, solids.size()); ++i) print_row(solids[i], kind);
  if (solids.size() > most_rows) print_out("and {} more\n", solids.size() - most_rows);
}

void require_sound(const MeshChoices& choices, const std::vector<Solid>& solids) {
  std::string text;
  for (const std::string& line : mesh::mesh_faults(choices.file, solids))
    text += (text.empty() ? "" : "\n") + line;
  if (!text.empty()) throw InputError(text);
}

/// An open mesh may be the rock of a case rather than a damaged solid.
std::string sheet_advice(const MeshChoices& choices, const std::vector<Solid>& solids) {
  if (solids.size() != 1 || mesh::open_edges(solids[0].mesh) == 0) return "";
  return fmt::format(
      "\n{}: if it is an open sheet, the rock of a case: tdbd mesh --sheet inspects "
      "it as one",
      choices.file);
}

/// Prints the table. For solids that are unsuitable for a bit, prints the faults and advice before
/// it and returns 2. The rock of a run is an open sheet and therefore not checked. With an output
/// file, converts the solids as they are.
int inspect(const MeshChoices& choices, const std::vector<Solid>& solids) {
  if (!choices.output.empty()) write(choices, solids);
  if (const auto stamp = simulation::read_stamp(choices.file)) {
    print_table(solids);
    print_out(
        "the rock of a run after {} steps, t = {:.6g} s: a sheet, which bounds no volume; its file "
        "is in metres\n",
        stamp->step, stamp->time);
    return 0;
  }
  std::string faults;
  try {
    require_sound(choices, solids);
  } catch (const InputError& e) {
    faults = e.what() + sheet_advice(choices, solids);
    fmt::print(stderr, "tdbd: {}\n", faults);
  }
  print_table(solids);
  return faults.empty() ? 0 : 2;
}

void require_output(const MeshChoices& choices) {
  const std::string& out = choices.output;
  if (out.empty()) throw InputError("--output: found no file, expected one: -o FILE");
  if (!fs::exists(out)) return;
  if (fs::equivalent(out, choices.file))
    throw InputError(out + ": found the input itself, expected another file to write");
  if (!choices.force) throw InputError(out + ": exists; --force replaces it");
}

/// Filling the cracks of a mesh whose points differ slightly would add a facet to each of them.
void require_no_cracks(const MeshChoices& choices, const std::vector<Solid>& solids) {
  const auto hint = mesh::crack_hint(solids);
  if (!hint) return;
  throw InputError(fmt::format("{}: {}\n{}: to repair: {}", choices.file, mesh::describe(*hint),
                               choices.file,
                               mesh::repair_command(choices.file, mesh::weld_text(*hint))));
}

int repair(const MeshChoices& choices, std::vector<Solid> solids) {
  const mesh::RepairOptions options{length("--weld", choices.weld)};
  if (options.weld == 0.0) require_no_cracks(choices, solids);
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
  write(choices, solids);
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
  write(choices, solids);
  print_table(solids);
  return 0;
}

void print_openings(const mesh::TriangleMesh& m) {
  const std::vector<mesh::Opening> all = mesh::openings(m);
  for (std::size_t i = 0; i < std::min(most_holes + 1, all.size()); ++i)
    print_out("{}\n", mesh::describe(all[i], i == 0 ? "rim" : "hole"));
  if (all.size() > most_holes + 1) print_out("and {} more\n", all.size() - most_holes - 1);
}

void change_sheet(const MeshChoices& choices, mesh::TriangleMesh& m) {
  if (choices.z_up) {
    mesh::turn_about_x(m);
    print_out("turned by half a turn about x: z points down\n");
  }
  if (choices.flip) {
    mesh::flip(m);
    print_out("facets flipped: {}\n", m.triangles.size());
  }
  if (!choices.fill_holes) return;
  std::string refusal;
  const std::size_t filled = mesh::fill_sheet_holes(m, refusal);
  if (!refusal.empty())
    throw InputError(fmt::format("{}: --fill-holes: {}", choices.file, refusal));
  print_out("holes filled: {}; the rim is unchanged\n", filled);
}

/// Rejects a mesh that cannot be the rock of a case, with what could make it one.
void require_sheet(const MeshChoices& choices, const mesh::TriangleMesh& m) {
  const std::vector<std::string> faults = mesh::sheet_faults(m);
  if (faults.empty()) return;
  std::string text;
  for (const std::string& line : faults) text += fmt::format("{}: {}\n", choices.file, line);
  const auto hint = mesh::weld_hint(m);
  if (hint)
    text += fmt::format("{}: {}\n", choices.file, mesh::describe(*hint));
  else if (!choices.fill_holes && mesh::openings(m).size() > 1)
    text += fmt::format("{}: --fill-holes fills the holes inside the rim\n", choices.file);
  throw InputError(text.substr(0, text.size() - 1));
}

/// Inspects the rock of a case, or changes it and writes the result if that can be a rock.
int inspect_sheet(const MeshChoices& choices, const mesh::LengthUnit& unit) {
  std::vector<std::string> warnings;
  mesh::TriangleMesh m = mesh::read_mesh(choices.file, unit.metres, &warnings);
  for (const std::string& warning : warnings) print_warning(warning);
  mesh::weld_points(m, length("--weld", choices.weld));
  print_openings(m);
  change_sheet(choices, m);
  require_sheet(choices, m);
  const std::string question =
      bit::unit_question(mesh::bounding_box(m).size().maxCoeff(), unit.metres, rock_along);
  if (!question.empty()) print_warning(fmt::format("{}: {}", choices.file, question));
  const std::vector<Solid> sheet = {{"sheet", m}};
  if (choices.writes()) write(choices, sheet);
  print_table(sheet, Surface::sheet);
  print_out("can be the rock of a case: one open sheet whose facets face up, out of the rock\n");
  return 0;
}

int inspect_or_write(const MeshChoices& choices) {
  const mesh::LengthUnit unit = unit_of_input(choices);
  if (choices.repair && choices.grade)
    throw InputError("--grade: found --repair as well, expected one of them at a time");
  if (choices.is_sheet() && (choices.repair || choices.grade))
    throw InputError(
        "--sheet: found --repair or --grade as well, which are for solids; expected --flip, "
        "--fill-holes or --z-up");
  if (choices.writes()) require_output(choices);
  if (choices.is_sheet()) return inspect_sheet(choices, unit);
  std::vector<std::string> warnings;
  std::vector<Solid> solids =
      mesh::read_solids(choices.file, unit.metres, length("--weld", choices.weld), &warnings);
  for (const std::string& warning : warnings) print_warning(warning);
  if (choices.repair) return repair(choices, std::move(solids));
  if (const double weld = length("--weld", choices.weld); weld > 0.0)
    for (Solid& solid : solids) mesh::weld_points(solid.mesh, weld);
  if (!choices.grade) return inspect(choices, solids);
  require_sound(choices, solids);
  return grade(choices, std::move(solids));
}

/// The options for the rock of a case.
void add_sheet_options(CLI::App& command, MeshChoices& choices) {
  command.add_flag("--sheet", choices.sheet,
                   "inspect an open sheet, the rock of a case: z points down, into the rock, and "
                   "facets face up, out of the rock");
  command.add_flag("--flip", choices.flip, "of a sheet: reverse all facets; requires -o");
  command.add_flag("--fill-holes", choices.fill_holes,
                   "of a sheet: fill all holes but the rim; requires -o");
  command.add_flag("--z-up", choices.z_up,
                   "of a sheet whose z points up: turn it by half a turn about x; requires -o");
}

/// The options for the file to write.
void add_output_options(CLI::App& command, MeshChoices& choices) {
  command
      .add_option(
          "-o,--output", choices.output,
          "the file to write, in the format of its extension; without --repair, --grade or a "
          "change of a sheet, the input is converted as it is")
      ->type_name(a_mesh_file);
  command.add_option("--output-unit", choices.output_unit,
                     "length unit of the output; default: that of the input, mm for STL, OBJ and "
                     "OFF from PLY");
  command.add_flag("--binary", choices.binary, "write STL as binary, without names of solids");
  command.add_flag("--force", choices.force, "replace the output file");
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
                      "length unit of the file; default: the unit that its header states, "
                      "otherwise mm");
  command->add_flag("--repair", choices->repair,
                    "repair the solids so that they are closed and face outward; requires -o");
  command
      ->add_option("--weld", choices->weld,
                   "merge points up to this far apart before anything else")
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
  add_sheet_options(*command, *choices);
  add_output_options(*command, *choices);
  command->footer("Example: tdbd mesh bit.stl --repair -o bit-repaired.stl");
  command->callback(
      [choices, &exit_code] { exit_code = guarded([&] { return inspect_or_write(*choices); }); });
}

}  // namespace tdbd::app
