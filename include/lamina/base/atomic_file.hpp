// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace lamina {

/// A file that appears under its name whole or not at all: it is written beside it under a temporary name
/// that nobody can guess, never through a link, and renamed by `commit`. Destroyed without `commit`, it
/// leaves nothing behind and an existing file untouched.
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
/// @throws FileError if it is missing, a folder, or cannot be read
std::string readFile(const std::string& path);

}  // namespace lamina
