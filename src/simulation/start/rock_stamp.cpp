#include "simulation/start/rock_stamp.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>

#include "core/config/csv.hpp"
#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

constexpr std::string_view step_key = "tdbd step ", time_key = "tdbd time_s ",
                           hash_key = "tdbd case_hash ";

/// The comments among the first lines of a PLY header.
std::vector<std::string> header_comments(const std::filesystem::path& file) {
  constexpr int most_lines = 64;
  constexpr std::string_view comment = "comment ";
  std::ifstream in(file, std::ios::binary);
  std::vector<std::string> comments;
  std::string line;
  for (int n = 0; n < most_lines && std::getline(in, line) && line != "end_header"; ++n) {
    if (n == 0 && line != "ply") return {};
    if (line.starts_with(comment)) comments.push_back(line.substr(comment.size()));
  }
  return comments;
}

std::optional<std::string> value_of(const std::vector<std::string>& comments,
                                    std::string_view key) {
  for (const std::string& line : comments)
    if (line.starts_with(key)) return line.substr(key.size());
  return std::nullopt;
}

}  // namespace

std::vector<std::string> comments_of(const RockStamp& stamp) {
  return {fmt::format("{}{}", step_key, stamp.step), fmt::format("{}{}", time_key, stamp.time),
          fmt::format("{}{}", hash_key, stamp.case_hash)};
}

std::optional<RockStamp> read_stamp(const std::filesystem::path& file) {
  std::error_code none;  // an unreadable file has no stamp; opening a pipe would block
  if (!std::filesystem::is_regular_file(file, none)) return std::nullopt;
  const std::vector<std::string> comments = header_comments(file);
  const auto step = value_of(comments, step_key), time = value_of(comments, time_key),
             hash = value_of(comments, hash_key);
  if (!step || !time || !hash) return std::nullopt;
  const std::optional<long> steps = csv_number<long>(*step);
  const std::optional<double> seconds = csv_number<double>(*time);
  if (!steps || !seconds) return std::nullopt;
  return RockStamp{*steps, *seconds, *hash};
}

void require_same_time(const Case& c) {
  if (c.time.first == 0) return;
  const std::optional<RockStamp> stamp = read_stamp(c.rock.file);
  constexpr double same = 1e-6;  // relative to a step: times are products with little rounding
  const double begin = time_at(c.time, c.time.first);
  if (!stamp || std::abs(stamp->time - begin) <= same * c.time.step) return;
  throw InputError(fmt::format(
      "{}: found {}, at t = {} s, expected {:.6g}: {} is the rock after step {}, at t = {} s (0 "
      "starts a new motion in this rock)",
      c.places.first_step, c.time.first, begin, stamp->time / c.time.step, c.rock.file, stamp->step,
      stamp->time));
}

}  // namespace tdbd::simulation
