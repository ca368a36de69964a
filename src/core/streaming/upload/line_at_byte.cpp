// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/line_at_byte.hpp"

#include <utility>

namespace lamina {

LineAtByte::LineAtByte(StreamableProgram program) : program_(std::move(program)) {}

void LineAtByte::rewind() {
  cursor_ = program_.open();
  next_ = cursor_->next();
  lines_ = 0;
  layer_ = -1;
}

std::uint64_t LineAtByte::linesBefore(std::uint64_t byte) {
  if (program_.hasChanged()) return lines_;
  if (!cursor_ || byte < last_byte_) rewind();
  last_byte_ = byte;
  while (next_ && cursor_->bytesRead() <= byte) {
    ++lines_;
    layer_ = next_->layer;
    next_ = cursor_->next();
  }
  return lines_;
}

}  // namespace lamina
