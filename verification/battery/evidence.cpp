#include "battery/evidence.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <system_error>

namespace tdbd::battery {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path evidence_folder() {
  const char* chosen = std::getenv("TDBD_EVIDENCE");
  return chosen != nullptr && *chosen != '\0' ? chosen : TDBD_EVIDENCE_FOLDER;
}

/// Relative to the build folder, so that the text does not depend on where that is.
std::string running_program() {
  return fs::read_symlink("/proc/self/exe")
      .lexically_relative(fs::path(TDBD_EVIDENCE_FOLDER).parent_path())
      .generic_string();
}

std::string running_test() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  if (test == nullptr) throw std::invalid_argument("evidence: recorded outside of a test");
  return std::string(test->test_suite_name()) + "." + test->name();
}

/// Lower-case letters and digits, one '-' for anything between them.
std::string slug(const std::string& text) {
  std::string made;
  for (const char c : text) {
    const bool is_digit = c >= '0' && c <= '9', is_capital = c >= 'A' && c <= 'Z';
    if (is_digit || is_capital || (c >= 'a' && c <= 'z'))
      made += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
    else if (!made.empty() && made.back() != '-')
      made += '-';
  }
  if (!made.empty() && made.back() == '-') made.pop_back();
  if (made.empty()) throw std::invalid_argument("evidence: nothing to name it by: " + text);
  return made;
}

void demand_slugs(const std::string& path) {
  static const std::regex slugs("[a-z0-9]+(-[a-z0-9]+)*(/[a-z0-9]+(-[a-z0-9]+)*)*");
  if (!std::regex_match(path, slugs)) throw std::invalid_argument("evidence: no slug: " + path);
}

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::holds_with_limits:
      return "holds with limits";
    case Verdict::refuted:
      return "refuted";
  }
  throw std::invalid_argument("evidence: no such verdict");
}

/// Written under another name first, so that no reader sees half a file. Tests run in parallel,
/// hence the process id in that name.
void write_whole(const fs::path& file, const Json& content) {
  fs::create_directories(file.parent_path());
  const fs::path partial = file.string() + "." + std::to_string(getpid()) + ".partial";
  std::ofstream out(partial, std::ios::binary);
  out << content.dump(1) << "\n";
  out.close();
  std::error_code error;
  if (out) fs::rename(partial, file, error);
  if (!out || error) {
    fs::remove(partial);
    throw std::runtime_error("evidence: cannot write " + file.string());
  }
}

}  // namespace

void record(const Evidence& e) {
  demand_slugs(e.claim);
  if (!std::isfinite(e.measured)) throw std::invalid_argument("evidence: not finite: " + e.what);
  write_whole(evidence_folder() / e.claim / (slug(e.what) + ".json"),
              {{"claim", e.claim},
               {"what", e.what},
               {"measured", e.measured},  // as many digits as give the same number back
               {"unit", e.unit},
               {"limit", e.limit},
               {"verdict", name_of(e.verdict)},
               {"test", running_test()},
               {"program", running_program()}});
}

void record_table(const std::string& name, const Json& rows) {
  demand_slugs(name);
  write_whole(evidence_folder() / "tables" / (name + ".json"),
              {{"test", running_test()}, {"program", running_program()}, {"rows", rows}});
}

}  // namespace tdbd::battery
