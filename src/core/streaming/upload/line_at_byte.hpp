// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// Finds the last command of a program before a position in its file.
class LineAtByte {
 public:
  explicit LineAtByte(StreamableProgram program);

  /// Number of commands that end at or before a byte of the file. A file that was changed is not read any
  /// further.
  std::uint64_t linesBefore(std::uint64_t byte);
  /// Layer of the last of these commands; -1 before the first.
  std::int32_t layer() const { return layer_; }

 private:
  void rewind();

  StreamableProgram program_;
  std::optional<ProgramCursor> cursor_;
  std::optional<ProgramLine> next_;
  std::uint64_t lines_ = 0;
  std::uint64_t last_byte_ = 0;
  std::int32_t layer_ = -1;
};

}  // namespace lamina
