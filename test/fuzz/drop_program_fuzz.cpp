// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/program/drops/drop_program.hpp"

namespace {

/// A new drop in each layer is read back there, or nothing is written.
void requireInsertable(const lamina::DropProgram& program) {
  const std::vector<std::vector<lamina::Point2>> added(program.layers.size(), {{1.0, 2.0}});
  const std::string text = withDrops(program, added, {});
  const lamina::DropProgram back = lamina::parseDropProgram(text, {});
  if (back.layers.size() != program.layers.size()) std::abort();
  for (std::size_t l = 0; l < added.size(); ++l)
    if (back.layers[l].drops.size() != program.layers[l].drops.size() + 1) std::abort();
}

}  // namespace

/// Any bytes are read as drops and written again byte for byte, or refused as InvalidProgram.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const std::string text(reinterpret_cast<const char*>(bytes), size);
    const lamina::DropProgram program = lamina::parseDropProgram(text, {});
    if (withDrops(program, {}, {}) != text) std::abort();
    requireInsertable(program);
  } catch (const lamina::InvalidProgram&) {
  }
  return 0;
}
