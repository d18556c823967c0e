#include "claims/blind_runs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "core/parallel.hpp"

namespace tdbd::claims {
namespace {

namespace fs = std::filesystem;
using calibration::Calibration;
using calibration::LaboratoryCase;
using calibration::Noise;
using calibration::Record;

constexpr Noise laboratory_noise{.reading = 0.03, .test = 0.03, .rop = 0.0};
constexpr Noise no_noise{.reading = 1e-12, .test = 0.0, .rop = 0.0};

const LaboratoryCase& laboratory(const std::string& law) {
  static std::map<std::string, LaboratoryCase> read;
  if (!read.contains(law))
    read[law] = calibration::read_laboratory(
        fmt::format("{}/validation/blind/hidden-{}.toml", TDBD_SOURCE_DIR, law), {});
  return read[law];
}

calibration::CutStore made_cuts(const calibration::CalibrationCase& c) {
  const ThreadLimit limit(2);
  const fs::path folder = fs::temp_directory_path() / fmt::format("tdbd-blind-{}", getpid());
  auto made = calibration::find_cuts(c, folder);
  fs::remove_all(folder);
  return made;
}

/// Cuts of all bits and depths on the laboratory's mesh and time step, which every hidden law shares.
const calibration::CutStore& laboratory_cuts() {
  static const calibration::CutStore store = made_cuts(laboratory("hanson-hansen").setup);
  return store;
}

std::vector<Record> tests_of(const LaboratoryCase& lab, const std::vector<std::string>& bits) {
  std::vector<Record> rows;
  for (const Record& r : lab.setup.records.rows)
    if (std::ranges::find(bits, r.tool) != bits.end()) rows.push_back(r);
  return rows;
}

std::vector<Record> drilled(const std::string& law, const std::vector<std::string>& bits,
                            const Noise& noise, int seed) {
  LaboratoryCase lab = laboratory(law);
  lab.setup.records.rows = tests_of(lab, bits);
  lab.setup.noise = noise;
  lab.seed = static_cast<std::uint64_t>(seed);
  return calibration::drill(lab, laboratory_cuts());
}

/// No two draws share a seed, nor do what is fitted and what is judged.
int fitted_seed(int draw) { return 2 * draw + 1; }
int truth_seed(int draw) { return 2 * draw + 2; }

const calibration::CalibrationCase& case_named(const std::string& name) {
  static std::map<std::string, calibration::CalibrationCase> read;
  if (!read.contains(name))
    read[name] = calibration::read_calibration(
        fmt::format("{}/validation/cases/lab-{}.toml", TDBD_SOURCE_DIR, name), {"noise.rop=0"});
  return read[name];
}

/// The same cuts on the coarser mesh and with the longer time step of the calibration.
const calibration::CutStore& fitted_cuts() {
  static const calibration::CutStore store = [] {
    calibration::CalibrationCase c = case_named("bc-a");
    c.records = laboratory("hanson-hansen").setup.records;
    return made_cuts(c);
  }();
  return store;
}

/// Loads that were predicted against those without noise, and intervals against noisy readings.
void judge(const Calibration& found, const std::vector<Record>& exact,
           const std::vector<Record>& read, Judged& j) {
  for (std::size_t i = 0; i < exact.size(); ++i)
    for (const std::size_t k : {calibration::axial, calibration::turning}) {
      const calibration::PredictedLoad& load = found.predictions[i].loads[k];
      j.errors.push_back(load.mean / *exact[i].readings[k].value - 1.0);
      const double reading = *read[i].readings[k].value;
      j.coverage += reading >= load.low && reading <= load.high ? 1.0 : 0.0;
    }
}

}  // namespace

const std::vector<Pairing>& pairings() {
  static const std::vector<Pairing> all{
      {"bc-a", {"B", "C"}, "A"}, {"ac-b", {"A", "C"}, "B"}, {"ab-c", {"A", "B"}, "C"}};
  return all;
}

std::map<std::string, double> truth_of(const std::string& law) {
  forces::Law truth = laboratory(law).setup.law;
  std::map<std::string, double> values;
  for (const forces::LawField& f : forces::law_fields(truth)) values[std::string(f.key)] = *f.value;
  return values;
}

calibration::CalibrationCase blind_case(const std::string& law, const Pairing& pairing,
                                        const std::string& suffix, int draw) {
  calibration::CalibrationCase c = case_named(pairing.name + suffix);
  c.records.rows = drilled(law, pairing.fitted, laboratory_noise, fitted_seed(draw));
  for (const Record& r : tests_of(laboratory(law), {pairing.withheld})) c.records.rows.push_back(r);
  return c;
}

const std::vector<Calibration>& calibrated(const std::string& law, const Pairing& pairing,
                                           const std::string& suffix, int count) {
  static std::map<std::tuple<std::string, std::string, std::string, int>, std::vector<Calibration>>
      made;
  auto& draws = made[{law, pairing.name, suffix, count}];
  for (int draw = static_cast<int>(draws.size()); draw < count; ++draw)
    draws.push_back(calibration::calibrate(blind_case(law, pairing, suffix, draw), fitted_cuts()));
  return draws;
}

Judged judged(const std::string& law, const Pairing& pairing, const std::string& suffix,
              int count) {
  const std::vector<Calibration>& draws = calibrated(law, pairing, suffix, count);
  const std::vector<Record> exact = drilled(law, {pairing.withheld}, no_noise, 0);
  Judged j;
  for (int draw = 0; draw < count; ++draw)
    judge(draws[static_cast<std::size_t>(draw)], exact,
          drilled(law, {pairing.withheld}, laboratory_noise, truth_seed(draw)), j);
  j.coverage /= static_cast<double>(j.errors.size());
  return j;
}

}  // namespace tdbd::claims
