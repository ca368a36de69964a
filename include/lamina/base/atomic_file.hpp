// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace lamina {

/// A file that appears under its name whole or not at all: it is written beside it under a temporary name
/// that nobody can guess, and renamed by `commit`. Destroyed without `commit`, it leaves nothing behind and
/// an existing file untouched. A link of one's own, or of root, stays one: what it names is replaced.
/// Another's link is replaced itself, for somebody may have led it to a file of ours.
class AtomicFile {
 public:
  /// @throws FileError if the folder cannot be written to
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// @throws FileError if the disk is full or gone
  void write(std::string_view bytes);

  /// Makes the file durable and visible under its name.
  /// @throws FileError if that fails; then the name holds what it held before
  void commit();

  /// The temporary name, for libraries that insist on opening the file themselves.
  const std::string& temporaryPath() const { return temporary_path_; }

 private:
  std::string path_;
  std::string temporary_path_;
  std::FILE* file_ = nullptr;
};

/// Writes the whole file, or leaves what was there.
/// @throws FileError if it cannot be written
void writeFile(const std::string& path, std::string_view bytes);

/// The whole file as bytes.
/// @throws FileError, Cancelled as `InputFile::readRest`
std::string readFile(const std::string& path);
/// The same, of so many bytes at most.
std::string readFile(const std::string& path, std::size_t most_bytes);

}  // namespace lamina
