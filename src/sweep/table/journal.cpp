#include "sweep/table/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/read_file.hpp"

namespace tdbd::sweep {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* file_name = "points.jsonl";
constexpr std::size_t seal_width = 16;  // hexadecimal digits, followed by a blank

Json number_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

std::string body_of(const std::string& key, const PointRecord& r) {
  Json figures = Json::array();
  for (const double x : r.outcome.figures) figures.push_back(number_or_null(x));
  const Json line{{"key", key},
                  {"failed", r.outcome.status == PointStatus::failed},
                  {"case_hash", r.outcome.case_hash},
                  {"message", r.outcome.message},
                  {"figures", figures},
                  {"steady", static_cast<int>(r.outcome.steady)},
                  {"seconds", r.seconds}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

PointRecord record_of(const Json& line) {
  PointRecord r;
  r.outcome.status = line.at("failed").get<bool>() ? PointStatus::failed : PointStatus::done;
  r.outcome.case_hash = line.at("case_hash");
  r.outcome.message = line.at("message");
  for (const Json& x : line.at("figures"))
    r.outcome.figures.push_back(x.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                            : x.get<double>());
  r.outcome.steady = static_cast<Steady>(line.value("steady", static_cast<int>(Steady::unknown)));
  r.seconds = line.at("seconds");
  return r;
}

/// Whether a line is complete and unchanged: its hash, a blank, its body.
bool is_whole(const std::string& line) {
  return line.size() > seal_width && line[seal_width] == ' ' &&
         line.compare(0, seal_width, fnv1a_hex(std::string_view(line).substr(seal_width + 1))) == 0;
}

/// Returns the number of bytes up to the last end of a line.
std::size_t whole_lines(const std::string& text) {
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? 0 : end + 1;
}

[[noreturn]] void fail(const fs::path& file) {
  throw RunError(fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
}

void read_journal(const fs::path& file, PointRecords& records) {
  const std::string text = read_file(file, "a journal of points");
  std::size_t begin = 0;
  for (long line = 1; begin < whole_lines(text); ++line) {
    const std::size_t end = text.find('\n', begin);
    const std::string one = text.substr(begin, end - begin);
    begin = end + 1;
    if (!is_whole(one))
      throw RunError(fmt::format(
          "{}:{}: found a line that is not as it was written; delete the line, and its point is "
          "run again",
          file.string(), line));
    const Json json = Json::parse(one.substr(seal_width + 1));
    records.emplace(json.at("key"), record_of(json));
  }
}

/// Creates the folder and returns its path.
const fs::path& made(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw RunError(fmt::format("cannot make {}: {}", folder.string(), error.message()));
  return folder;
}

}  // namespace

Journal::Journal(const fs::path& folder)
    : file_(made(folder) / file_name),
      lock_(folder),
      descriptor_(open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_APPEND, 0666)) {
  if (descriptor_ < 0) fail(file_);
  if (ftruncate(descriptor_,
                static_cast<off_t>(whole_lines(read_file(file_, "a journal of points")))) != 0)
    fail(file_);
}

Journal::~Journal() { close(descriptor_); }

void Journal::add(const std::string& key, const PointRecord& record) {
  const std::string body = body_of(key, record);
  const std::string line = fmt::format("{} {}\n", fnv1a_hex(body), body);
  const off_t before = lseek(descriptor_, 0, SEEK_END);
  std::size_t written = 0;
  while (written < line.size()) {
    const ssize_t n = write(descriptor_, line.data() + written, line.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      const int why = errno;
      if (before >= 0 && ftruncate(descriptor_, before) != 0) errno = why;
      errno = why;
      fail(file_);
    }
    written += static_cast<std::size_t>(n);
  }
}

PointRecords read_journals(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (fs::is_regular_file(entry.path() / file_name)) files.push_back(entry.path() / file_name);
  std::ranges::sort(files);
  PointRecords records;
  for (const fs::path& file : files) read_journal(file, records);
  return records;
}

}  // namespace tdbd::sweep
