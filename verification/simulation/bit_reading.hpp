#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.hpp"
#include "simulation/bit_file.hpp"

namespace tdbd::simulation {

inline bit::Bit read(const std::string& file,
                     bit::DirectionRule rule = bit::DirectionRule::hybrid) {
  return read_bit(file, rule, bit::InsideRule::down).bit;
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

}  // namespace tdbd::simulation
