// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/program/five_axis/five_axis_reader.hpp"
#include "support/table_machine.hpp"

/// Any bytes are read into a valid toolpath or refused as InvalidProgram.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const lamina::test::TableMachine machine;
  try {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    lamina::validate(lamina::readFiveAxis(text, machine, {}, {}, "fuzz"));
  } catch (const lamina::InvalidProgram&) {
  } catch (const lamina::InvalidInput&) {
    std::abort();  // `validate` refuses what the reader made
  }
  return 0;
}
