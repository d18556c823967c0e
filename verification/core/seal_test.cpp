#include "core/seal.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "verification/core/temporary_file.hpp"

namespace tdbd::seal_test {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

RC_GTEST_PROP(Seal, lets_pass_what_was_sealed, (const std::string& bytes)) {
  const fs::path path = write_temporary(".bin", bytes);
  seal_file(path);
  require_seal(path);
  RC_ASSERT(read_file(path, "a file").starts_with(bytes));
}

RC_GTEST_PROP(Seal, refuses_any_change_of_a_byte, (const std::string& bytes)) {
  const fs::path path = write_temporary(".bin", bytes);
  seal_file(path);
  std::string changed = read_file(path, "a file");
  const std::size_t i = *rc::gen::inRange<std::size_t>(0, changed.size());
  changed[i] = static_cast<char>(changed[i] ^ *rc::gen::inRange(1, 256));
  write(path, changed);
  RC_ASSERT_THROWS_AS(require_seal(path), RunError);
}

RC_GTEST_PROP(Seal, refuses_what_is_torn, (const std::string& bytes)) {
  const fs::path path = write_temporary(".bin", bytes);
  seal_file(path);
  fs::resize_file(path, *rc::gen::inRange<std::uintmax_t>(0, fs::file_size(path)));
  RC_ASSERT_THROWS_AS(require_seal(path), RunError);
}

TEST(Seal, of_a_file_that_is_not_there_is_refused) {
  EXPECT_THROW(require_seal("/no/such/file"), RunError);
  EXPECT_THROW(seal_file("/no/such/file"), RunError);
}

}  // namespace
}  // namespace tdbd::seal_test
