// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"

/// Any bytes are read into a valid toolpath or refused as InvalidProgram.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const std::string_view program(reinterpret_cast<const char*>(bytes), size);
    const lamina::Toolpath toolpath = lamina::toolpathFromGcode(program, lamina::ProgramSettings{}, "fuzz");
    lamina::validate(toolpath);
  } catch (const lamina::InvalidProgram&) {
  } catch (const lamina::InvalidInput&) {
    std::abort();  // `validate` refuses what the reader made
  }
  return 0;
}
