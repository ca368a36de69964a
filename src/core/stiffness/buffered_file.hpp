// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/atomic_file.hpp"

namespace lamina {

/// A file that is written whole or not at all, a mebibyte at a time.
class BufferedFile {
 public:
  /// @throws FileError if it cannot be written, as the other calls
  explicit BufferedFile(const std::string& path) : file_(path) {}

  void append(const std::string& bytes) {
    buffer_ += bytes;
    if (buffer_.size() > kFlush) flush();
  }
  /// Ends the file, which takes the place of what was there.
  void commit() {
    flush();
    file_.commit();
  }

 private:
  static constexpr std::size_t kFlush = std::size_t{1} << 20;

  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }

  AtomicFile file_;
  std::string buffer_;
};

}  // namespace lamina
