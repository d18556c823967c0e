#include "io/checkpoint.hpp"

#include <fmt/format.h>

#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "io/whole_file.hpp"

namespace tdbd {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "tdbd checkpoint 3\n";

/// Returns "step = 0.001" for "step = 0.001  # s".
std::string without_comment(const std::string& line) { return line.substr(0, line.find("  #")); }

/// Returns the first line of a case that differs, preceded by the name of its table.
std::string first_difference(const std::string& was, const std::string& is) {
  std::istringstream old_text(was), new_text(is);
  std::string expected, found, table;
  while (true) {
    const bool has_old = static_cast<bool>(std::getline(old_text, expected)),
               has_new = static_cast<bool>(std::getline(new_text, found));
    if (!has_old && !has_new) return "the content of an input file";
    if (expected != found || has_old != has_new)
      return fmt::format("{}found {}, expected {}", table,
                         has_new ? without_comment(found) : "nothing more",
                         has_old ? without_comment(expected) : "nothing more");
    if (found.starts_with('[')) table = found + " ";
  }
}

void put_in_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw RunError(fmt::format("cannot write {}: {}", to.string(), error.message()));
}

}  // namespace

void write_checkpoint_file(const fs::path& path, const CheckpointFile& file) {
  ArchiveWriter write{std::string(first_line)};
  write(file.version, file.of.hash, file.of.text, file.state);
  write_sealed(path, std::move(write).archive().bytes);
}

CheckpointFile read_checkpoint_file(const fs::path& path) {
  const std::string bytes = read_sealed(path);
  if (!bytes.starts_with(first_line))
    throw RunError(fmt::format("checkpoint {}: it is no checkpoint", path.string()));
  CheckpointFile file;
  ArchiveReader read(std::string_view(bytes).substr(first_line.size()));
  read(file.version, file.of.hash, file.of.text, file.state);
  read.require_end();
  return file;
}

void refuse_checkpoint(const fs::path& path, const std::string& reason) {
  throw InputError(fmt::format("checkpoint {}: {}", path.string(), reason));
}

Archive archive_of(const fs::path& path, const CaseMark& c) {
  CheckpointFile file = read_checkpoint_file(path);
  if (file.version != provenance().version)
    refuse_checkpoint(
        path, fmt::format("written by tdbd {}, this is {}", file.version, provenance().version));
  if (file.of.hash != c.hash)
    refuse_checkpoint(path, fmt::format("the case has changed since: {}",
                                        first_difference(file.of.text, c.text)));
  return std::move(file.state);
}

CheckpointKeeper::CheckpointKeeper(OutputFolder folder, long every, Warn warn)
    : folder_(std::move(folder)), every_(every), warn_(std::move(warn)) {}

template <class Do>
void CheckpointKeeper::attempt(Do&& act) {
  try {
    act();
  } catch (const std::exception& e) {
    if (!has_failed_ && warn_)
      warn_(fmt::format("{}; the run continues and can be resumed from its last good checkpoint",
                        error_message_of(e)));
    has_failed_ = true;
  }
}

/// A missing row would also be missing in the record of the resumed run. Therefore no checkpoint is
/// written after a failure.
template <class Do>
void CheckpointKeeper::log_or_end(Do&& act) {
  try {
    act();
  } catch (...) {
    end_logs();
    throw;
  }
}

void CheckpointKeeper::end_logs() {
  log_.reset();
  profiles_.reset();
}

RowLog* CheckpointKeeper::rows(RowsOf of) {
  std::optional<RowLog>& log = log_of(of);
  return log ? &*log : nullptr;
}

void CheckpointKeeper::begin_rows(std::size_t width, long kept, RowsOf of) {
  if (every_ == 0) return;
  const bool is_history = of == RowsOf::history;
  if (!is_history && !log_) return;
  const auto begin = [&] {
    log_of(of).emplace(is_history ? folder_.rows() : folder_.profile_rows(), width, kept);
  };
  if (kept > 0) return begin();
  attempt([&] { log_or_end(begin); });
}

void CheckpointKeeper::append(std::span<const double> row, RowsOf of) {
  RowLog* log = rows(of);
  if (log == nullptr) return;
  attempt([&] { log_or_end([&] { log->append(row); }); });
}

bool CheckpointKeeper::is_due(long steps_done) const {
  constexpr double share = 0.01, soonest = 10.0;  // of the run time; s
  if (!log_ || every_ == 0) return false;
  if (every_ > 0) return steps_done % every_ == 0;
  const std::chrono::duration<double> passed = Clock::now() - last_;
  return passed.count() > soonest && passed > cost_ / share;
}

/// At any moment, one complete checkpoint exists under one of its names.
void CheckpointKeeper::replace(const Write& write) const {
  write(folder_.new_checkpoint());
  if (fs::exists(folder_.checkpoint()))
    put_in_place(folder_.checkpoint(), folder_.previous_checkpoint());
  put_in_place(folder_.new_checkpoint(), folder_.checkpoint());
}

void CheckpointKeeper::keep(const Write& write) {
  if (!log_) return;
  const auto begin = Clock::now();
  attempt([&] {
    log_or_end([&] {
      log_->sync();
      if (profiles_) profiles_->sync();
    });
    replace(write);
  });
  last_ = Clock::now();
  cost_ = last_ - begin;
}

void CheckpointKeeper::remove() {
  end_logs();
  remove_checkpoints(folder_);
}

void remove_checkpoints(const OutputFolder& folder) {
  std::error_code ignored;
  for (const fs::path& file : {folder.new_checkpoint(), folder.checkpoint(),
                               folder.previous_checkpoint(), folder.rows(), folder.profile_rows()})
    for (const fs::path& name : {file, partial_path(file)}) fs::remove(name, ignored);
}

namespace {

bool is_complete(const fs::path& checkpoint) {
  if (!fs::exists(checkpoint)) return false;
  try {
    require_seal(checkpoint);
    return true;
  } catch (const RunError&) {
    return false;
  }
}

}  // namespace

void keep_newest_checkpoint(const OutputFolder& folder) {
  std::error_code ignored;
  if (is_complete(folder.new_checkpoint()))  // a kill before it was renamed
    fs::rename(folder.new_checkpoint(), folder.checkpoint(), ignored);
  if (!fs::exists(folder.checkpoint(), ignored)) return;
  for (const fs::path& file : {folder.new_checkpoint(), folder.previous_checkpoint()})
    for (const fs::path& name : {file, partial_path(file)}) fs::remove(name, ignored);
}

bool read_newest_checkpoint(const OutputFolder& folder,
                            const std::function<long(const fs::path&)>& read,
                            const CheckpointKeeper::Warn& warn) {
  std::string torn;
  for (const fs::path& file :
       {folder.new_checkpoint(), folder.checkpoint(), folder.previous_checkpoint()}) {
    if (!fs::exists(file)) continue;
    try {
      const long steps = read(file);
      if (!torn.empty() && warn)
        warn(fmt::format("{}; {} is whole, after {} steps: the run continues from there", torn,
                         file.filename().string(), steps));
      return true;
    } catch (const RunError& e) {
      torn += (torn.empty() ? "" : "; ") + std::string(e.what());
    }
  }
  if (!torn.empty()) throw InputError(torn + "; there is no older one");
  return false;
}

}  // namespace tdbd
