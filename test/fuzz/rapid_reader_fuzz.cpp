// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/program/rapid/reader/rapid_reader.hpp"

/// Any bytes are read into a valid toolpath or refused as InvalidProgram.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    lamina::validate(lamina::readRapid({{"fuzz.mod", text}}, "fuzz"));
  } catch (const lamina::InvalidProgram&) {
  } catch (const lamina::InvalidInput&) {
    std::abort();  // `validate` refuses what the reader made
  }
  return 0;
}
