// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/streaming/resume/remaining_program.hpp"

/// Any bytes are a program that is checked for every firmware, and whose rest is written, or are refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const auto program =
        lamina::StreamableProgram::fromText("fuzz", std::string(reinterpret_cast<const char*>(bytes), size));
    const auto drop = [](std::string_view) {};
    lamina::writeRemaining(program, (program.lines() + 1) / 2, 1000.0, lamina::ResumeSettings{}, drop);
  } catch (const lamina::InvalidInput&) {
  }
  return 0;
}
