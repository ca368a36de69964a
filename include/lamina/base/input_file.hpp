// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lamina {

/// A file open for reading from its start, for files too large to be held whole.
class InputFile {
 public:
  /// @throws FileError if it is missing, a folder, or cannot be read
  explicit InputFile(std::string path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// [bytes] when it was opened; 0 for what has no size, such as a pipe.
  std::size_t size() const { return size_; }

  /// Reads the next bytes into the buffer: as many as asked for, fewer only at the end of the file.
  /// @return how many
  /// @throws FileError
  std::size_t read(char* buffer, std::size_t count);

  /// The bytes given, which were read before, and all that follow.
  /// @throws FileError
  std::string readRest(std::string_view read_before = {});

 private:
  std::string path_;
  int descriptor_ = -1;
  std::size_t size_ = 0;
};

}  // namespace lamina
