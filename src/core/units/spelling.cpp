#include "core/units/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/text.hpp"

namespace tdbd::units {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

/// Characters beyond ASCII in UTF-8, and what they mean in a quantity.
constexpr auto characters = std::to_array<Pair>({
    {"\u00A0", " "},     {"\u2000", " "},     {"\u2001", " "},      {"\u2002", " "},
    {"\u2003", " "},     {"\u2004", " "},     {"\u2005", " "},      {"\u2006", " "},
    {"\u2007", " "},     {"\u2008", " "},     {"\u2009", " "},      {"\u200A", " "},
    {"\u202F", " "},     {"\u205F", " "},     {"\u3000", " "},      {"\u200B", ""},
    {"\u200C", ""},      {"\u200D", ""},      {"\u2060", ""},       {"\uFEFF", ""},
    {"\u00AD", ""},      {"\u2010", "-"},     {"\u2011", "-"},      {"\u2012", "-"},
    {"\u2013", "-"},     {"\u2212", "-"},     {"\u207B", "-"},      {"\u00B7", "."},
    {"\u22C5", "."},     {"\u2219", "."},     {"\u2022", "."},      {"\u2024", "."},
    {"\u00D7", "*"},     {"\u2217", "*"},     {"\u2044", "/"},      {"\u2215", "/"},
    {"\u00F7", "/"},     {"\u2070", "0"},     {"\u00B9", "1"},      {"\u00B2", "2"},
    {"\u00B3", "3"},     {"\u2074", "4"},     {"\u2075", "5"},      {"\u2076", "6"},
    {"\u2077", "7"},     {"\u2078", "8"},     {"\u2079", "9"},      {"\u207A", "+"},
    {"\u00B5", "u"},     {"\u03BC", "u"},     {"\u2032", "'"},      {"\u2033", "\""},
    {"\u201D", "\""},    {"\u2019", "'"},     {"\u2103", "degC"},   {"\u2109", "degF"},
    {"\u00B0C", "degC"}, {"\u00B0F", "degF"}, {"\u00B0 C", "degC"}, {"\u00B0 F", "degF"},
    {"\u00B0", "deg"},   {"\u00BA", "deg"},   {"\u00BD", " 1/2"},   {"\u00BC", " 1/4"},
    {"\u00BE", " 3/4"},  {"\u215B", " 1/8"},  {"\u215C", " 3/8"},   {"\u215D", " 5/8"},
    {"\u215E", " 7/8"},  {"\uFF0C", ","},     {"\u066B", ","},      {"\uFF0E", "."},
});

/// Whole names, in lower case and without blanks, points, hyphens and asterisks.
constexpr auto whole_names = std::to_array<Pair>({
    {"nm", "N m"},
    {"knm", "kN m"},
    {"dannm", "daN m"},
    {"danm", "daN m"},
    {"ftlb", "ft lbf"},
    {"ftlbs", "ft lbf"},
    {"ftlbf", "ft lbf"},
    {"lbft", "ft lbf"},
    {"lbsft", "ft lbf"},
    {"lbfft", "ft lbf"},
    {"ftlbsf", "ft lbf"},
    {"footpounds", "ft lbf"},
    {"footpound", "ft lbf"},
    {"footlbs", "ft lbf"},
    {"poundfeet", "ft lbf"},
    {"poundfoot", "ft lbf"},
    {"kftlb", "ft klbf"},
    {"kftlbs", "ft klbf"},
    {"kftlbf", "ft klbf"},
    {"klbft", "ft klbf"},
    {"klbfft", "ft klbf"},
    {"ftklb", "ft klbf"},
    {"ftklbf", "ft klbf"},
    {"ftkips", "ft klbf"},
    {"kipft", "ft klbf"},
    {"kipsft", "ft klbf"},
    {"inlb", "in lbf"},
    {"inlbs", "in lbf"},
    {"inlbf", "in lbf"},
    {"lbin", "in lbf"},
    {"lbfin", "in lbf"},
    {"lbsin", "in lbf"},
    {"nm/rad", "N m/rad"},
    {"knm/rad", "kN m/rad"},
    {"nm/deg", "N m/deg"},
    {"knm/deg", "kN m/deg"},
    {"nms/rad", "N m s/rad"},
    {"knms/rad", "kN m s/rad"},
    {"nms", "N m s"},
    {"ns/m", "N s/m"},
    {"nm2", "N m2"},
    {"knm2", "kN m2"},
    {"kgm2", "kg m2"},
    {"kgm", "kg m"},
    {"rpm", "rpm"},
    {"r/min", "rpm"},
    {"revs/min", "rpm"},
    {"rev/min", "rpm"},
    {"u/min", "rpm"},
    {"tr/min", "rpm"},
    {"rot/min", "rpm"},
    {"turns/min", "rpm"},
    {"rps", "rev/s"},
    {"r/s", "rev/s"},
    {"revs/s", "rev/s"},
    {"revs/sec", "rev/s"},
    {"psi", "psi"},
    {"psia", "psi"},
    {"lbf/in2", "psi"},
    {"lbs/in2", "psi"},
    {"lb/in2", "psi"},
    {"lb/sqin", "psi"},
    {"ksi", "klbf/in^2"},
    {"kpsi", "klbf/in^2"},
    {"bars", "bar"},
    {"bara", "bar"},
    {"kip", "klbf"},
    {"kips", "klbf"},
    {"lbsf", "lbf"},
    {"lbfs", "lbf"},
    {"klbsf", "klbf"},
    {"klbfs", "klbf"},
    {"fph", "ft/h"},
    {"ft/hr", "ft/h"},
    {"feet/hr", "ft/h"},
    {"feet/hour", "ft/h"},
    {"fpm", "ft/min"},
    {"fps", "ft/s"},
    {"m/hr", "m/h"},
    {"mtr/hr", "m/h"},
    {"ins", "in"},
    {"\"", "in"},
    {"''", "in"},
    {"'", "ft"},
    {"mtr", "m"},
    {"mtrs", "m"},
    {"mtr.", "m"},
    {"g/cc", "g/cm3"},
    {"gm/cc", "g/cm3"},
    {"gr/cc", "g/cm3"},
    {"gm/cm3", "g/cm3"},
    {"g/ccm", "g/cm3"},
    {"lb/gal", "ppg"},
    {"lbs/gal", "ppg"},
    {"lbm/gal", "ppg"},
    {"pcf", "lb/ft^3"},
    {"ppf", "lb/ft"},
    {"sqin", "in^2"},
    {"sqmm", "mm2"},
    {"sqft", "ft^2"},
    {"degs", "deg"},
    {"msec", "ms"},
    {"msecs", "ms"},
    {"pct", "%"},
    {"c", "degC"},
});

/// Words of a compound unit, in lower case.
constexpr auto usual_case = std::to_array<Pair>({
    {"n", "N"},       {"kn", "kN"},     {"dan", "daN"}, {"lbs", "lb"},    {"lbm", "lb"},
    {"hr", "h"},      {"hrs", "h"},     {"hour", "h"},  {"hours", "h"},   {"sec", "s"},
    {"secs", "s"},    {"mins", "min"},  {"r", "rev"},   {"revs", "rev"},  {"pa", "Pa"},
    {"kpa", "kPa"},   {"gpa", "GPa"},   {"hz", "Hz"},   {"khz", "kHz"},   {"w", "W"},
    {"kw", "kW"},     {"j", "J"},       {"kj", "kJ"},   {"k", "K"},       {"degs", "deg"},
    {"degc", "degC"}, {"degf", "degF"}, {"ins", "in"},  {"inches", "in"}, {"kgs", "kg"},
    {"rads", "rad"},  {"cc", "cm3"},    {"ltr", "L"},
});

/// Names with more than one meaning, in lower case and without separators.
constexpr auto several = std::to_array<Pair>({
    {"lb", "lbf"},         {"lbs", "lbf"},         {"pound", "lbf"},    {"pounds", "lbf"},
    {"klb", "klbf"},       {"klbs", "klbf"},       {"kg", "kgf"},       {"kgs", "kgf"},
    {"mph", "m/h"},        {"mph", "mile/h"},      {"psig", "psi"},     {"barg", "bar"},
    {"kg/cm2", "kgf/cm2"}, {"ksc", "kgf/cm2"},     {"mpa", "MPa"},      {"mpa", "mPa"},
    {"hz", "rev/s"},       {"1/s", "rad/s"},       {"1/s", "rev/s"},    {"1/min", "rpm"},
    {"min1", "rpm"},       {"cpm", "rpm"},         {"sg", "g/cm3"},     {"kgm", "kgf m"},
    {"mkg", "kgf m"},      {"mnm", "MN m"},        {"mnm", "mN m"},     {"lb/in", "lbf/in"},
    {"lbs/in", "lbf/in"},  {"lb/ft2", "lbf/ft^2"}, {"psf", "lbf/ft^2"}, {"f", "degF"},
});

std::string squeezed(std::string_view name) {
  std::string s = lower_case(name);
  std::erase_if(s, [](char c) { return c == ' ' || c == '.' || c == '-' || c == '*' || c == '^'; });
  return s;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The name with every word in its usual case: "KN/M" is "kN/m".
std::string usual_words(std::string_view name) {
  std::string all;
  while (!name.empty()) {
    std::size_t n = 0;
    while (n < name.size() && is_letter(name[n])) ++n;
    if (n == 0) {
      all += name.front();
      name.remove_prefix(1);
      continue;
    }
    const std::string word = lower_case(name.substr(0, n));
    const auto usual = std::ranges::find(usual_case, word, &Pair::first);
    all += usual == usual_case.end() ? word : std::string(usual->second);
    name.remove_prefix(n);
  }
  return all;
}

/// The length of a text of digits, with their separators, at a place.
std::size_t run_of(std::string_view text, std::string_view allowed, std::size_t from) {
  return std::min(text.find_first_not_of(allowed, from), text.size()) - from;
}

/// Whether the digits are in groups of three behind the first separator: "1,234,567".
bool is_grouped(std::string_view digits, char separator) {
  const std::size_t first = digits.find(separator);
  if (first == 0 || first > 3) return false;
  for (std::size_t at = first; at < digits.size(); at += 4)
    if (digits[at] != separator || run_of(digits, "0123456789", at + 1) != 3) return false;
  return true;
}

std::string without(std::string_view text, char c) {
  std::string s(text);
  std::erase(s, c);
  return s;
}

/// "30 000 lbf" as "30000 lbf"; other texts are unchanged.
std::string joined_groups(const std::string& text, std::size_t sign) {
  if (sign == text.size() || !is_digit(text[sign])) return text;
  const std::size_t n = run_of(text, "0123456789 ", sign);
  std::string_view digits = trimmed(std::string_view(text).substr(sign, n));
  const std::size_t end = sign + digits.size();
  const bool ends = end == text.size() || (!is_digit(text[end]) && text[end] != '/');
  const bool fraction = text.substr(sign + n, 1) == "/";
  if (digits.find(' ') == std::string_view::npos || !is_grouped(digits, ' ') || !ends || fraction)
    return text;
  return text.substr(0, sign) + without(digits, ' ') + text.substr(end);
}

/// "8 1/2 in" as "8.5 in"; empty if there is no fraction.
std::string decimal_of_fraction(std::string_view text, std::size_t sign) {
  std::array<double, 3> n{};
  std::size_t at = sign;
  const auto take = [&](double& x) {
    const std::size_t length = run_of(text, "0123456789", at);
    if (length == 0 || length > 9) return false;
    std::from_chars(text.data() + at, text.data() + at + length, x);
    at += length;
    return true;
  };
  if (!take(n[0])) return "";
  if (text.substr(at, 1) == "/") {  // "1/2 in"
    n[1] = std::exchange(n[0], 0.0);
  } else {
    const std::size_t from = at;
    at += run_of(text, " -", at);
    if (at == from || !take(n[1])) return "";
  }
  if (text.substr(at, 1) != "/") return "";
  ++at;
  if (!take(n[2]) || n[2] == 0.0) return "";
  return fmt::format("{}{:g} {}", text.substr(0, sign), n[0] + n[1] / n[2],
                     trimmed(text.substr(at)));
}

/// The number that starts with these digits, points and commas; empty if it has no one meaning.
std::string with_point(std::string_view digits) {
  const auto commas = std::ranges::count(digits, ','), points = std::ranges::count(digits, '.');
  const std::size_t comma = digits.find(','), point = digits.find('.');
  if (commas == 1 && points == 0) {
    const std::size_t decimals = digits.size() - comma - 1;
    const bool both = decimals == 3 && comma > 0 && comma <= 3 && digits[0] != '0';
    return both || decimals == 0
               ? ""
               : fmt::format("{}.{}", digits.substr(0, comma), digits.substr(comma + 1));
  }
  if (points <= 1 && (points == 0 || point > digits.rfind(','))) {
    const std::string_view whole = digits.substr(0, point);
    return is_grouped(whole, ',') ? without(digits, ',') : "";
  }
  if (commas != 1 || comma < digits.rfind('.')) return "";
  const std::string_view whole = digits.substr(0, comma);
  if (!is_grouped(whole, '.')) return "";
  return fmt::format("{}.{}", without(whole, '.'), digits.substr(comma + 1));
}

}  // namespace

std::string plain_characters(std::string_view text) {
  std::string all(text);
  if (std::ranges::none_of(all, [](char c) { return (c & 0x80) != 0; })) return all;
  for (const auto& [from, to] : characters)
    for (std::size_t at = 0; (at = all.find(from, at)) != std::string::npos; at += to.size())
      all.replace(at, from.size(), to);
  return std::string(trimmed(all));
}

NumberText plain_number(std::string_view given) {
  std::string text(given);
  if (text.find_first_of(", /'") == std::string::npos) return {text, ""};
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  if (const std::string decimal = decimal_of_fraction(text, sign); !decimal.empty())
    return {text, fmt::format("\"{}\"", decimal)};
  text = joined_groups(text, sign);
  const std::size_t n = run_of(text, "0123456789.,", sign);
  const std::string digits = text.substr(sign, n), rest = text.substr(sign + n);
  if (digits.find(',') == std::string::npos) return {text, ""};
  const std::string number = with_point(digits);
  if (!number.empty()) return {text.substr(0, sign) + number + rest, ""};
  const std::string point =
      std::ranges::count(digits, ',') == 1 && digits.find('.') == digits.npos
          ? digits.substr(0, digits.find(',')) + "." + digits.substr(digits.find(',') + 1)
          : "";
  const std::string both =
      point.empty() ? "" : fmt::format(" or \"{}{}{}\"", text.substr(0, sign), point, rest);
  return {text,
          fmt::format("\"{}{}{}\"{}", text.substr(0, sign), without(digits, ','), rest, both)};
}

std::vector<std::string> other_spellings(std::string_view name) {
  std::vector<std::string> units;
  const std::string key = squeezed(name);
  // The case of M decides between mega and milli.
  const bool mega = name.starts_with('M');
  if (mega && key == "mpa") units.emplace_back("MPa");
  if (mega && key == "mn") units.emplace_back("MN");
  if (mega && key == "mnm") units.emplace_back("MN m");
  for (const auto& [other, unit] : whole_names)
    if (other == key) units.emplace_back(unit);
  if (name.ends_with('.')) units.emplace_back(name.substr(0, name.size() - 1));
  units.push_back(usual_words(name));
  if (units.back().ends_with('.')) units.back().pop_back();
  return units;
}

std::string suggested_units(std::string_view number, std::string_view name,
                            const UnitPowers& expected) {
  std::string all;
  const std::string key = squeezed(name);
  for (const auto& [other, unit] : several) {
    if (other != key) continue;
    const auto found = find_unit(std::string(unit));
    if (found && found->powers() == expected)
      all += fmt::format("{}\"{} {}\"", all.empty() ? "" : " or ", number, unit);
  }
  return all;
}

}  // namespace tdbd::units
