// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/base/input_file.hpp"

namespace lamina {

/// Reads the lines of a file, block by block in constant memory.
class LineReader {
 public:
  /// @throws FileError if the file cannot be read
  explicit LineReader(const std::string& path);

  /// The next line without its line feed, valid until the next call; nothing at the end.
  /// @throws InvalidProgram if the line is longer than 1 MiB
  std::optional<std::string_view> next();

  std::size_t number() const { return number_; }  ///< number of the line returned last, from 1
  std::size_t bytesRead() const { return bytes_read_; }
  std::size_t size() const { return file_.size(); }  ///< [bytes]

 private:
  bool fill();

  std::string path_;
  InputFile file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t number_ = 0;
  std::size_t bytes_read_ = 0;
};

}  // namespace lamina
