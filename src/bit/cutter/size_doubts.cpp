#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "bit/cutter/table_doubts.hpp"

namespace tdbd::bit {
namespace {

constexpr double one_mm = 1e-3;
constexpr double least_bit = 20e-3, largest_bit = 1200e-3;
constexpr double least_cutter = 3e-3, largest_cutter = 60e-3, larger_bit = 50e-3;

/// Units in which lengths may be written under the name of another one, in the order of the guesses.
struct Guess {
  const char* words;
  const char* suffix;
  double factor;  ///< of the values as they were read
};
constexpr std::array<Guess, 5> guesses{{{"inches", "in", 25.4},
                                        {"cm", "cm", 10.0},
                                        {"m", "m", 1000.0},
                                        {"mm", "mm", 1.0 / 25.4},
                                        {"micrometres", "", 1e-3}}};

double third_largest_radius(const std::vector<Cutter>& cutters) {
  std::vector<double> radii;
  for (const Cutter& c : cutters) radii.push_back(c.tip_radius);
  std::ranges::nth_element(radii, radii.begin() + 2, std::greater{});
  return radii[2];
}

double middle_of(const std::vector<Cutter>& cutters, double Cutter::*member) {
  std::vector<double> all;
  for (const Cutter& c : cutters) all.push_back(c.*member);
  std::ranges::nth_element(all, all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2));
  return all[all.size() / 2];
}

bool is_bit(double across) { return across > least_bit && across < largest_bit; }
bool is_cutter(double diameter) { return diameter > 5e-3 && diameter < 30e-3; }

/// The unit that makes bit and cutters usual; otherwise the first one that makes the bit usual.
const Guess* unit_of_bit(double across, double diameter) {
  const Guess* found = nullptr;
  for (const Guess& g : guesses) {
    if (!is_bit(g.factor * across)) continue;
    if (is_cutter(g.factor * diameter)) return &g;
    if (found == nullptr) found = &g;
  }
  return found;
}

std::string question(const Guess* guess) {
  if (guess == nullptr) return "";
  const std::string suffix(guess->suffix);
  return fmt::format("; are lengths in {}{}?", guess->words,
                     suffix.empty() ? "" : " (then name the column r_tip_" + suffix + ")");
}

TableDoubt of_table(const std::vector<Cutter>& cutters, const char* column, std::string found,
                    std::string expected, Severity severity) {
  return {cutters.front().line, column, std::move(found), std::move(expected), severity};
}

/// A column of lengths with its usual values.
struct Feature {
  const char* column;
  double Cutter::*member;
  double least, most;  ///< m, of the largest value
};

constexpr std::array<Feature, 5> features{
    {{"chamfer_mm", &Cutter::chamfer, 0.08e-3, 4e-3},
     {"land_mm", &Cutter::land, 0.02e-3, 8e-3},
     {"length_mm", &Cutter::length, 2e-3, 80e-3},
     {"table_mm", &Cutter::table_thickness, 0.3e-3, 12e-3},
     {"under_exposure_mm", &Cutter::under_exposure, 0.15e-3, 15e-3}}};

/// The unit in which a value is usual: inches that were read as mm, or the opposite.
const Guess* unit_of_feature(double x, const Feature& f) {
  for (const Guess& g : guesses)
    if (std::string_view(g.words) != "micrometres" && g.factor * x >= f.least &&
        g.factor * x <= f.most)
      return &g;
  return nullptr;
}

std::string name_in(const char* column, const Guess& g) {
  const std::string name(column);
  return name.substr(0, name.rfind('_') + 1) + g.suffix;
}

}  // namespace

std::vector<TableDoubt> size_doubts(const std::vector<Cutter>& cutters) {
  constexpr std::size_t fewest = 3, usual_number = 8;
  constexpr double too_wide = 0.5;  // a cutter over the bit
  if (cutters.size() < fewest) return {};
  const double across = 2.0 * third_largest_radius(cutters);
  const double diameter = middle_of(cutters, &Cutter::diameter);
  const bool many = cutters.size() >= usual_number;
  const Severity wrong = many ? Severity::impossible : Severity::doubtful;
  if (across < least_bit || across > largest_bit) {
    const Guess* guess = unit_of_bit(across, diameter);
    if (!many && guess == nullptr) return {};
    return {of_table(cutters, "r_tip_mm", fmt::format("a bit of {:.4g} mm", across / one_mm),
                     "20 to 1200 mm" + question(guess), wrong)};
  }
  // A large bit in inches is as wide as a small one in mm, but its cutters are not.
  const Guess* guess = unit_of_bit(across, diameter);
  const bool both =
      diameter < least_cutter && guess != nullptr && is_cutter(guess->factor * diameter);
  if (both && across <= larger_bit)
    return {of_table(cutters, "r_tip_mm",
                     fmt::format("a bit of {:.4g} mm with cutters of {:.4g} mm", across / one_mm,
                                 diameter / one_mm),
                     "cutters of 3 to 60 mm" + question(guess), wrong)};
  if (many && diameter > too_wide * across)
    return {of_table(cutters, "r_tip_mm",
                     fmt::format("a bit of {:.4g} mm with {} cutters of {:.4g} mm", across / one_mm,
                                 cutters.size(), diameter / one_mm),
                     "a bit wider than its cutters" + question(&guesses[0]), wrong)};
  if (across > larger_bit && (diameter < least_cutter || diameter > largest_cutter)) {
    const bool inches = diameter < least_cutter;
    const bool in_mm = !inches && is_cutter(diameter / 25.4);
    return {of_table(cutters, "dia_mm", fmt::format("cutters of {:.4g} mm", diameter / one_mm),
                     fmt::format("3 to 60 mm{}", inches  ? "; are diameters in inches (dia_in)?"
                                                 : in_mm ? "; are diameters in mm (dia_mm)?"
                                                         : ""),
                     Severity::doubtful)};
  }
  return {};
}

std::vector<TableDoubt> feature_doubts(const std::vector<Cutter>& cutters) {
  constexpr double unlike = 8.0;  // times smaller or larger than the others
  std::vector<TableDoubt> doubts;
  if (cutters.empty()) return doubts;
  for (const Feature& f : features) {
    double largest = 0.0;
    for (const Cutter& c : cutters) largest = std::max(largest, c.*f.member);
    if (largest == 0.0 || (largest >= f.least && largest <= f.most)) continue;
    const Guess* guess = unit_of_feature(largest, f);
    if (guess == nullptr) continue;
    doubts.push_back(of_table(
        cutters, f.column, fmt::format("at most {:.4g} mm", largest / one_mm),
        fmt::format("usually {:.3g} to {:.3g} mm; are lengths in {} (then name the column {})?",
                    f.least / one_mm, f.most / one_mm, guess->words, name_in(f.column, *guess)),
        Severity::doubtful));
  }
  const double usual = middle_of(cutters, &Cutter::diameter);
  for (const Cutter& c : cutters)
    if (c.diameter * unlike < usual || c.diameter > unlike * usual)
      doubts.push_back(
          {c.line, "dia_mm", fmt::format("{:.4g} mm of cutter {}", c.diameter / one_mm, c.id),
           fmt::format("about {:.4g} mm, like the others; is this row in {}?", usual / one_mm,
                       c.diameter < usual ? "inches" : "another unit")});
  return doubts;
}

}  // namespace tdbd::bit
