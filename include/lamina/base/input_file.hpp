// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lamina {

/// As large as a file of settings, of a description or of a plate may be [bytes].
inline constexpr std::size_t kMostSettingsBytes = std::size_t{64} << 20;

/// A file open for reading from its start, for files too large to be held whole.
///
/// Regular files alone, so that no pipe is waited for and no device is read without end; `/dev/stdin` and
/// `/dev/fd/N` may be whatever they are. A signal that comes while such a pipe is waited for ends the wait.
class InputFile {
 public:
  /// @throws FileError if it is missing, cannot be read, or is no regular file: says what it is
  explicit InputFile(std::string path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// [bytes] when it was opened; 0 for what has no size, such as a pipe.
  std::size_t size() const { return size_; }

  /// Reads the next bytes into the buffer: as many as asked for, fewer only at the end of the file.
  /// @return how many
  /// @throws FileError; Cancelled if a signal came while a pipe was waited for
  std::size_t read(char* buffer, std::size_t count);

  /// The bytes given, which were read before, and all that follow, as far as memory holds them.
  /// @throws FileError if there are more: says how many; as `read`
  std::string readRest(std::string_view read_before = {});
  /// The same, of so many bytes at most.
  std::string readRest(std::string_view read_before, std::size_t most_bytes);

 private:
  void wait() const;

  std::string path_;
  int descriptor_ = -1;
  std::size_t size_ = 0;
};

/// @throws FileError as `InputFile`, for what other libraries open themselves
void requireReadable(const std::string& path);

}  // namespace lamina
