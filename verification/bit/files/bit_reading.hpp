#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bit/files/bit_file.hpp"
#include "core/error.hpp"

namespace tdbd::bit {

inline Bit read(const std::string& file, DirectionRule rule = DirectionRule::hybrid) {
  return read_bit(file, rule, InsideRule::down).bit;
}

/// The message that reading the bit gives; empty if it is read.
inline std::string complaint(const std::string& file) {
  try {
    read(file);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

inline void expect_words(const std::string& message, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
}

}  // namespace tdbd::bit
