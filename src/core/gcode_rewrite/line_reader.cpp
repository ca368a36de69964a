// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/line_reader.hpp"

#include <cstring>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 20U;

}  // namespace

LineReader::LineReader(const std::string& path) : path_(path), file_(path), buffer_(kBuffer) {}

bool LineReader::fill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  const bool is_start = bytes_read_ == 0;
  const std::size_t got = file_.read(buffer_.data() + end_, kBuffer - end_);
  end_ += got;
  if (is_start) begin_ = end_ - utf8Text({buffer_.data(), end_}, path_).size();
  bytes_read_ += got;
  return got > 0;
}

std::optional<std::string_view> LineReader::next() {
  std::size_t searched = 0;
  for (;;) {
    const char* from = buffer_.data() + begin_;
    const std::size_t held = end_ - begin_;
    const void* feed = held > searched ? std::memchr(from + searched, '\n', held - searched) : nullptr;
    if (feed != nullptr) {
      const auto length = static_cast<std::size_t>(static_cast<const char*>(feed) - from);
      begin_ += length + 1;
      ++number_;
      return std::string_view(from, length);
    }
    searched = held;
    if (held == kBuffer) throw InvalidProgram("line " + std::to_string(number_ + 1) + ": longer than 1 MiB");
    if (!fill()) break;
  }
  if (begin_ == end_) return std::nullopt;
  const std::string_view last(buffer_.data() + begin_, end_ - begin_);
  begin_ = end_;
  ++number_;
  return last;
}

}  // namespace lamina
