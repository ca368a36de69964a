// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "program/robot/reader/line_cursor.hpp"

namespace lamina {

/// Reads a program line by line.
class LineSequence {
 public:
  /// @param file   for errors; must outlive the sequence, as must the text of the lines
  /// @param begin  index of the first line that is read
  LineSequence(std::vector<std::string_view> lines, const ReadFile& file, std::size_t begin = 0)
      : lines_(std::move(lines)), file_(&file), next_(begin) {}

  bool isAtEnd() const { return next_ == lines_.size(); }
  LineCursor nextLine() {
    const std::string_view text = lines_[next_++];
    return {text, next_, *file_};
  }
  /// The next line, without reading past it.
  LineCursor lineAhead() const { return {lines_[next_], next_ + 1, *file_}; }
  /// An empty line after the last one, for errors about a missing line.
  LineCursor end() const { return {"", lines_.size() + 1, *file_}; }
  /// The same lines, none of them read.
  LineSequence fromStart() const { return {lines_, *file_}; }

 private:
  std::vector<std::string_view> lines_;
  const ReadFile* file_;
  std::size_t next_;
};

}  // namespace lamina
