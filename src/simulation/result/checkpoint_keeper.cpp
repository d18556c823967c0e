#include "simulation/result/checkpoint_keeper.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/reason.hpp"
#include "core/whole_file.hpp"

namespace tdbd::simulation {
namespace {

namespace fs = std::filesystem;

void put_in_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw RunError(fmt::format("cannot write {}: {}", to.string(), error.message()));
}

}  // namespace

CheckpointKeeper::CheckpointKeeper(OutputFolder folder, long every, Warn warn)
    : folder_(std::move(folder)), every_(every), warn_(std::move(warn)) {}

template <class Do>
void CheckpointKeeper::attempt(Do&& act) {
  try {
    act();
  } catch (const std::exception& e) {
    if (!has_failed_ && warn_)
      warn_(fmt::format("{}; the run goes on, to be resumed from its last good checkpoint",
                        reason_of(e)));
    has_failed_ = true;
  }
}

/// A row that is missing would be missing in the record of the run that goes on: no checkpoint
/// follows.
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
  constexpr double share = 0.01, soonest = 10.0;  // of the time; s
  if (!log_ || every_ == 0) return false;
  if (every_ > 0) return steps_done % every_ == 0;
  const std::chrono::duration<double> passed = Clock::now() - last_;
  return passed.count() > soonest && passed > cost_ / share;
}

/// At any moment one whole checkpoint has one of its names.
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
        warn(fmt::format("{}; {} is whole, after {} steps: the run goes on from there", torn,
                         file.filename().string(), steps));
      return true;
    } catch (const RunError& e) {
      torn += (torn.empty() ? "" : "; ") + std::string(e.what());
    }
  }
  if (!torn.empty()) throw InputError(torn + "; there is no older one");
  return false;
}

}  // namespace tdbd::simulation
