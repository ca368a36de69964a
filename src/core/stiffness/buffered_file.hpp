// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/atomic_file.hpp"

namespace lamina {

/// A file that is written completely or not at all, through a buffer of one mebibyte.
class BufferedFile {
 public:
  /// @throws FileError if the file cannot be written; so do the other calls
  explicit BufferedFile(const std::string& path) : file_(path) {}

  void append(const std::string& bytes) {
    buffer_ += bytes;
    if (buffer_.size() > kFlush) flush();
  }
  /// Finishes the file, which then replaces the one that was there.
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
