#include "sweep/point/prepared_bits.hpp"

#include <algorithm>
#include <deque>
#include <mutex>
#include <string>
#include <utility>

#include "rock/cut/cutting_bit.hpp"

namespace tdbd::sweep {
namespace {

constexpr std::size_t most_kept = 16;  // some megabytes each

struct PreparedBits {
  std::mutex mutex;
  std::deque<std::pair<std::string, std::shared_ptr<const rock::CuttingBit>>>
      bits;  ///< by bit_hash, the oldest first

  std::shared_ptr<const rock::CuttingBit> find(const std::string& hash) {
    const std::lock_guard hold(mutex);
    const auto found = std::ranges::find_if(bits, [&](const auto& b) { return b.first == hash; });
    return found == bits.end() ? nullptr : found->second;
  }
  void keep(const std::string& hash, std::shared_ptr<const rock::CuttingBit> bit) {
    const std::lock_guard hold(mutex);
    if (bits.size() == most_kept) bits.pop_front();
    bits.emplace_back(hash, std::move(bit));
  }
};

}  // namespace

std::shared_ptr<const rock::CuttingBit> prepared_bit(const simulation::Case& c) {
  static PreparedBits kept;
  if (auto found = kept.find(c.bit_hash)) return found;
  auto made =
      std::make_shared<const rock::CuttingBit>(rock::prepare_cutting_bit(c.bit, c.update.cutting));
  kept.keep(c.bit_hash, made);
  return made;
}

}  // namespace tdbd::sweep
