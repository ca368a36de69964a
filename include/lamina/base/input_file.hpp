// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace lamina {

class HeldSignals;

/// Greatest size of a file of settings, of a description or of a plate [bytes].
inline constexpr std::size_t kMostSettingsBytes = std::size_t{64} << 20;

/// Greatest number of bytes of a file that may be held in memory: 80 % of the available memory; a third of
/// that for a file without a size, such as a pipe, as a growing buffer is copied to a buffer of twice its
/// size.
/// @param size  size of the file [bytes]; 0 if it has none
std::size_t mostBytesInMemory(double available_bytes, std::size_t size);

/// Kind of a file that is not regular, with its article, by the mode that the system states: "a folder", "a
/// pipe".
const char* kindOfFile(unsigned mode);

/// A file open for reading from its start, for files that are too large to be held as a whole.
///
/// Only regular files are opened, so that reading neither waits for a pipe nor reads a device without end;
/// `/dev/stdin` and `/dev/fd/N` may also be a pipe, a socket or a device. A signal that arrives while a pipe
/// is waited for ends the wait. SIGINT, SIGTERM and SIGHUP end the reading, wherever the bytes come from:
/// from the first `read` to the end of the file the reading thread receives them in `read` only. The same
/// thread must destroy the object.
class InputFile {
 public:
  /// @throws FileError if it does not exist, cannot be read, or is not a regular file; the message states
  ///   what it is
  explicit InputFile(std::string path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Size [bytes] when the file was opened; 0 for a file without a size, such as a pipe.
  std::size_t size() const { return size_; }

  /// Reads the next bytes into the buffer: `count` of them, fewer only at the end of the file.
  /// @return number of bytes read
  /// @throws FileError if it cannot be read; Cancelled if a signal arrived since the last call, or while a
  ///   pipe was waited for
  std::size_t read(char* buffer, std::size_t count);

  /// The bytes `read_before`, which were read earlier, followed by the rest of the file. All of it may take
  /// up to `mostBytesInMemory`.
  /// @throws FileError if there are more bytes than that, stating how many; as `read`
  std::string readRest(std::string_view read_before = {});
  /// The bytes `read_before`, followed by the rest of the file, if these are at most `most_bytes` together.
  /// @throws FileError if there are more bytes, stating how many; as `read`
  std::string readRest(std::string_view read_before, std::size_t most_bytes);

 private:
  void wait() const;

  std::string path_;
  int descriptor_ = -1;
  std::size_t size_ = 0;
  std::unique_ptr<const HeldSignals> held_;  ///< while the file is being read
};

/// The path as it is or, if there is no such file, the path of the file in the same folder whose name differs
/// in the case of ASCII letters only, as controllers write names in capitals. Of several, the first in order.
/// @throws FileError that names the file and the reason, if its folder cannot be listed
std::string pathInAnyCase(const std::string& path);

/// Checks a file that another library is going to open.
/// @throws FileError as `InputFile`
void requireReadable(const std::string& path);

}  // namespace lamina
