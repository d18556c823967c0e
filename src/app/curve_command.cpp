#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "app/arguments.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "io/whole_file.hpp"
#include "simulation/case/case_kind.hpp"
#include "sweep/curve/curve.hpp"

namespace tdbd::app {
namespace {

namespace fs = std::filesystem;

struct CurveArguments : ResultArguments {
  std::string weights, rate, rocks, strengths;
  double tolerance = 0.02;
  long runs = 8;
  int threads = 1;
};

/// A list of quantities as given, and in SI.
struct QuantityList {
  std::vector<std::string> texts;  ///< "10 kN"
  std::vector<double> values;
};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> items;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    items.emplace_back(trimmed(std::string_view(text).substr(begin, end - begin)));
    begin = end + 1;
  }
  return items;
}

/// Reads "10,20,30 kN": values without a unit have that of the last one.
QuantityList quantity_list(const std::string& option, const std::string& text,
                           const std::string& si_unit, const std::string& example) {
  QuantityList list;
  const std::vector<std::string> items = split(text);
  const std::string unit = sweep::level_of({items.back(), ""}).unit;
  for (const std::string& item : items) {
    const sweep::Level level = sweep::level_of({item, ""});
    const std::string whole =
        level.number ? fmt::format("{} {}", *level.number, level.unit.empty() ? unit : level.unit)
                     : item;
    double value = 0.0;
    try {
      value = to_si(whole, si_unit);
    } catch (const UnitError&) {  // reported below: 0 is out of range
    }
    if (!(value > 0.0))
      throw InputError(fmt::format("{}: found '{}', expected values > 0 with a unit, such as {}",
                                   option, item, example));
    list.texts.push_back(whole);
    list.values.push_back(value);
  }
  return list;
}

std::vector<sweep::CurveRock> rocks_of(const CurveArguments& a, const simulation::Case& c) {
  std::vector<sweep::CurveRock> rocks;
  if (!a.rocks.empty())
    for (const std::string& name : split(a.rocks)) try {
        rocks.push_back(sweep::rock_by_name(name));
      } catch (const InputError& e) {
        throw InputError(fmt::format("--rocks: {}", e.what()));
      }
  if (!a.strengths.empty()) {
    const QuantityList list = quantity_list("--strengths", a.strengths, "Pa", "60,100 MPa");
    for (std::size_t i = 0; i < list.values.size(); ++i)
      rocks.push_back(sweep::rock_by_strength(c, list.texts[i], list.values[i]));
  }
  if (rocks.empty()) rocks.push_back({"rock of the case", {}});
  std::set<std::string> names;
  for (const sweep::CurveRock& rock : rocks)
    if (!names.insert(rock.name).second)
      throw InputError(
          fmt::format("--rocks, --strengths: found {} twice, expected each rock once", rock.name));
  return rocks;
}

sweep::CurvePlan plan_of(const CurveArguments& a) {
  if (a.weights.empty() && a.rate.empty())
    throw InputError(
        "found neither --weights nor --rate, expected --weights 10,20,30kN for a curve, --rate "
        "15m/h for the weight that gives a rate, or both");
  sweep::CurvePlan plan{.case_file = a.case_file, .overrides = a.overrides};
  if (!a.weights.empty()) {
    plan.weights = quantity_list("--weights", a.weights, "N", "10,20,30 kN").values;
    std::ranges::sort(plan.weights);
    const auto repeated = std::ranges::unique(plan.weights);
    plan.weights.erase(repeated.begin(), repeated.end());
  }
  if (!a.rate.empty())
    plan.rate = option_quantity("--rate", a.rate, "m/s", Range::positive(), "a rate");
  plan.tolerance = a.tolerance;
  plan.most_runs = a.runs;
  simulation::require_kind(a.case_file, a.overrides, {simulation::CaseKind::drilling});
  const simulation::Case c = simulation::read_case(a.case_file, a.overrides);
  sweep::require_weight_driven(c);
  plan.rocks = rocks_of(a, c);
  return plan;
}

/// The result folder. Rejects a folder with other files, unless --force is given.
fs::path curve_folder(const CurveArguments& a) {
  const fs::path folder = result_folder(a, "-curve");
  const bool is_curve = fs::is_directory(folder / "curve.points");
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder)) && !is_curve &&
      !a.force)
    throw InputError(
        fmt::format("-o: found {}, which no curve wrote, expected a new folder (or "
                    "--force)",
                    folder.string()));
  return folder;
}

/// "12.34 +- 0.05": at least one significant digit of the interval.
std::string mean_text(double value, double interval, double unit) {
  if (!std::isfinite(value)) return "failed";
  if (!std::isfinite(interval)) return fmt::format("{:.4g}", value / unit);
  return fmt::format("{:.4g} +- {:.2g}", value / unit, interval / unit);
}

void print_curve_table(const sweep::CurveResult& result) {
  constexpr double kilo = 1e3, hour = 3600.0, mega = 1e6;
  constexpr std::size_t most_rows = 40;
  std::size_t width = 4, rows = 0;
  for (const sweep::Curve& curve : result.curves) width = std::max(width, curve.rock.size());
  print_out("{:<{}}  {:>10}  {:>18}  {:>18}  {:>18}  {:>8}\n", "rock", width, "set, kN",
            "weight, kN", "rate, m/h", "torque, N m", "MSE, MPa");
  for (const sweep::Curve& curve : result.curves)
    for (const sweep::CurvePoint& p : curve.points) {
      if (++rows > most_rows) continue;
      print_out(
          "{:<{}}  {:>10.4g}  {:>18}  {:>18}  {:>18}  {:>8}{}\n", curve.rock, width,
          p.weight_set / kilo, mean_text(p.wob, p.wob_interval, kilo),
          mean_text(p.rop, p.rop_interval, 1.0 / hour), mean_text(p.tob, p.tob_interval, 1.0),
          std::isfinite(p.specific_energy) ? fmt::format("{:.4g}", p.specific_energy / mega) : "-",
          p.steady == sweep::Steady::no ? "  not steady" : "");
    }
  if (rows > most_rows) print_out("... and {} more rows in curve.csv\n", rows - most_rows);
}

/// Prints the warnings of a curve, also with --quiet.
void print_curve_warnings(const sweep::CurveResult& result) {
  if (result.same_in_all_rocks)
    print_warning(
        "the force law of the cutters ignores the strength of the rock: the curves of the rocks "
        "hardly differ; give the law coefficients of each rock");
  for (const sweep::Curve& curve : result.curves)
    for (const sweep::CurvePoint& p : curve.points)
      if (!p.message.empty())
        print_warning(
            fmt::format("{} at {:.4g} N failed: {}", curve.rock, p.weight_set, p.message));
}

/// Prints the table, and the weights for the rate.
void print_curve(const sweep::CurvePlan& plan, const sweep::CurveResult& result,
                 const fs::path& folder) {
  print_curve_table(result);
  if (plan.rate)
    for (const sweep::Curve& curve : result.curves)
      print_out("{}\n", sweep::rate_text(plan, curve));
  print_out("table in {}; to draw it: tdbd draw {}\n", (folder / "curve.csv").string(),
            folder.string());
}

/// 0 if every rate that was looked for was found, else 1.
int exit_code_of(const sweep::CurvePlan& plan, const sweep::CurveResult& result) {
  const auto has_answer = [&plan](const sweep::Curve& c) {
    return !plan.rate || c.end == sweep::RateEnd::found || c.end == sweep::RateEnd::within_interval;
  };
  return std::ranges::all_of(result.curves, has_answer) ? 0 : 1;
}

int draw_up_curve(const CurveArguments& a) {
  const sweep::CurvePlan plan = plan_of(a);
  const fs::path folder = curve_folder(a);
  Progress progress;
  sweep::SweepOptions options{folder / "curve.nc", {}, a.threads, &save_on_interrupt()};
  options.warn = print_warning;
  if (!a.quiet)
    options.progress = [&](long done, long total) {
      if (progress.is_due(done, total)) progress.show(done, total, "  runs");
    };
  const sweep::CurveResult result = sweep::run_curve(plan, options);
  if (result.interrupted) {
    if (!a.quiet) {
      progress.finish();
      print_out("interrupted; repeat the command to continue\n");
    }
    return interrupted_code;
  }
  write_text(folder / "curve.csv", sweep::curve_csv(result));
  if (plan.rate) write_text(folder / "rates.csv", sweep::rates_csv(plan, result));
  if (!a.quiet) progress.finish();
  print_curve_warnings(result);
  if (!a.quiet) print_curve(plan, result, folder);
  return exit_code_of(plan, result);
}

void add_curve_options(CLI::App& command, CurveArguments& a) {
  command
      .add_option("--weights", a.weights,
                  "weights on bit, with the unit after the last one: 10,20,30kN")
      ->type_name("LIST");
  command
      .add_option("--rate", a.rate,
                  "find the weight for this rate of penetration, in every rock: 15m/h")
      ->type_name("RATE");
  command.add_option("--rocks", a.rocks, "names of rocks: berea-sandstone,mancos-shale")
      ->type_name("LIST");
  command
      .add_option("--strengths", a.strengths,
                  "unconfined strengths of the rock of the case: 60,100MPa")
      ->type_name("LIST");
  command
      .add_option("--tolerance", a.tolerance, "largest difference from the rate, relative to it")
      ->check(CLI::Range(1e-4, 0.5))
      ->capture_default_str();
  command.add_option("--runs", a.runs, "most runs of the search in each rock, besides --weights")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
}

}  // namespace

void add_curve(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "curve", "Run a case at several weights on bit: rate and torque, and the weight for a rate");
  auto a = std::make_shared<CurveArguments>();
  const ResultHelp help{.case_file = "a case (TOML) that drills under a weight_on_bit",
                        .folder = "results/CASE-curve",
                        .set = "--set time.duration='2 s'",
                        .quiet = "no progress, no table"};
  add_case(*command, *a, help);
  add_curve_options(*command, *a);
  add_result_options(*command, *a, help);
  add_threads(*command, a->threads);
  command->footer(
      "Writes curve.csv and, with --rate, rates.csv; tdbd draw FOLDER draws them. Finished\n"
      "runs are stored in FOLDER: after an interruption the same command continues, and other\n"
      "weights use them. The exit code is 1 if a rate was not found. The duration of the case is\n"
      "that of each run; expected_rate and torque_at_start are those of the case.\n"
      "Example: tdbd curve cases/drill-bit-b.toml --weights 10,20,30kN --rate 15m/h");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return draw_up_curve(*a); }); });
}

}  // namespace tdbd::app
