#include "calibration/laboratory/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "calibration/case/read_setup.hpp"
#include "calibration/fit/problem.hpp"
#include "calibration/laboratory/laboratory_keys.hpp"
#include "calibration/predict/prediction.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "io/whole_file.hpp"
#include "simulation/case/force_keys.hpp"

namespace tdbd::calibration {
namespace {

using namespace laboratory_keys;

forces::Law read_truth(Config& c, const std::string& name) {
  forces::Law law = forces::law_named(name);
  Config given = c.table(truth);
  for (const forces::LawField& f : forces::law_fields(law))
    *f.value = given.read(simulation::force_keys::key_of(f), f.fallback);
  return law;
}

std::vector<double> read_list(Config& top, const ListKey& key, Range range) {
  const std::vector<double> values = top.read(key);
  if (values.empty()) top.problem(key, "none", "at least one");
  for (const double v : values)
    if (!range.contains(v))
      top.problem(key, fmt::format("{:.6g}", v), fmt::format("values{}", range.text()));
  return values;
}

/// One test per bit and pressure, one reading per rate.
std::vector<Record> plan(const std::vector<std::string>& names,
                         const std::vector<double>& all_pressures,
                         const std::vector<double>& all_rates, double speed) {
  std::vector<Record> records;
  for (const std::string& name : names)
    for (const double p : all_pressures)
      for (const double rate : all_rates) {
        Record r;
        r.test = fmt::format("{}-{:.4g}MPa", name, p / forces::MPa);
        r.tool = name;
        r.pressure = p;
        r.speed = speed;
        r.rate = rate;
        r.depth = rate * 2.0 * std::numbers::pi / speed;
        records.push_back(r);
      }
  return records;
}

std::vector<std::string> names_of(const std::vector<Tool>& tools) {
  std::vector<std::string> names;
  names.reserve(tools.size());
  for (const Tool& t : tools) names.push_back(t.name);
  return names;
}

void require_known(Config& top, const std::vector<std::string>& chosen,
                   const std::vector<std::string>& known) {
  for (const std::string& name : chosen)
    if (std::ranges::find(known, name) == known.end())
      top.problem(laboratory_keys::bits, fmt::format("'{}'", name),
                  fmt::format("one of {}", fmt::join(known, ", ")));
}

}  // namespace

LaboratoryCase read_laboratory(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  LaboratoryCase result;
  CalibrationCase& setup = result.setup;
  setup.path = path;
  Config top = c.table(table);
  setup.law = read_truth(c, top.read(law));
  setup.tools = read_tools(c);
  setup.areas = read_area_laws(c, setup.law, setup.tools, AreaValues::truth, setup.unknowns);
  setup.rock = read_test_rock(c);
  setup.grid = read_grid(c);
  setup.noise = read_noise(c.table(calibration_keys::noise));
  const auto known = names_of(setup.tools);
  setup.fit = top.read(laboratory_keys::bits, known);
  require_known(top, setup.fit, known);
  const auto all_pressures = read_list(top, pressures, Range::non_negative());
  const auto all_rates = read_list(top, rates, Range::positive());
  setup.records.rows = plan(setup.fit, all_pressures, all_rates, top.read(rotary_speed));
  result.seed = static_cast<std::uint64_t>(top.read(seed));
  c.finish();
  result.setup.files = c.files();
  return result;
}

std::vector<Record> drill(const LaboratoryCase& c, const CutStore& cuts) {
  Random random{c.seed};
  const CalibrationCase& setup = c.setup;
  std::vector<Record> records = setup.records.rows;
  const std::vector<forces::Law> laws = laws_of_mixes(setup.areas, setup.law);
  std::map<std::string, double> factors;
  for (Record& r : records) {
    if (!factors.contains(r.test)) factors[r.test] = setup.noise.test * normal(random);
    const Sample sample = sample_of(setup, cuts, r);
    const Loads loads = mean_loads(laws, sample), slopes = depth_slopes(laws, sample);
    const double rate_error = setup.noise.rop * normal(random);
    for (const std::size_t k : {axial, turning}) {
      const double noise =
          factors[r.test] + slopes[k] * rate_error + setup.noise.reading * normal(random);
      r.readings[k].value = loads[k] * std::exp(noise);
    }
  }
  return records;
}

std::string records_csv(const std::vector<Record>& records) {
  std::string text =
      "test,bit,pressure [Pa],rotary_speed [rad/s],rate_of_penetration [m/s],wob [N],tob [N m]\n";
  for (const Record& r : records)
    text += fmt::format("{},{},{},{},{},{},{}\n", r.test, r.tool, r.pressure, r.speed, r.rate,
                        *r.readings[axial].value, *r.readings[turning].value);
  return text;
}

namespace {

namespace fs = std::filesystem;

/// Throws if the file must not be written: it is an input, or it exists and may not be overwritten.
void require_writable_output(const fs::path& file, const LaboratoryOptions& o,
                             const std::vector<std::string>& inputs) {
  if (!fs::exists(file)) return;
  for (const std::string& input : inputs)
    if (fs::equivalent(file, input))
      throw InputError(file.string() + ": found an input itself, expected another file to write");
  if (o.overwrite == Overwrite::no)
    throw FolderError(fmt::format("{}: exists; --force overwrites", file.string()));
}

}  // namespace

void write_records(const LaboratoryCase& c, const LaboratoryOptions& o) {
  const ThreadLimit limit(o.threads);
  const fs::path file = fs::absolute(o.file).lexically_normal();
  require_writable_output(file, o, c.setup.files);
  const fs::path cuts = o.cuts.empty() ? file.parent_path() / "cuts" : o.cuts;
  const CutStore store = find_cuts(c.setup, cuts, o.progress);
  fs::create_directories(file.parent_path());
  write_text(file, records_csv(drill(c, store)));
}

}  // namespace tdbd::calibration
