// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace lamina {

/// A file that appears under its name completely or not at all. It is written under an unpredictable
/// temporary name in the same folder, and renamed by `commit`. Destroyed without `commit`, it leaves no file,
/// and an existing file unchanged. If the name is a symbolic link of this user or of root, the link is kept
/// and the file that it leads to is replaced. A link of another user is itself replaced, since that user may
/// have made it lead to one of our files.
class AtomicFile {
 public:
  /// @throws FileError if the folder cannot be written to, or if the name is that of a folder, a device, a
  ///   pipe or a socket, which a file would replace
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// @throws FileError if the disk is full or gone
  void write(std::string_view bytes);

  /// Closes the file and makes it visible under its name. The file is not forced to the disk, which would
  /// take 3 ms to 16 ms, while slicing a small part takes 20 ms. After a loss of power the file may be
  /// missing, empty or the earlier one. Files that must survive a loss of power are written by
  /// `writeDurably`, or synchronised.
  /// @throws FileError if that fails; an earlier file of that name is then unchanged
  void commit();

  /// The temporary name, for libraries that have to open the file themselves.
  const std::string& temporaryPath() const { return temporary_path_; }

 private:
  std::string path_;
  std::string temporary_path_;
  std::FILE* file_ = nullptr;
};

/// Writes a file completely, or leaves an earlier file of that name as it was.
/// @throws FileError if it cannot be written
void writeFile(const std::string& path, std::string_view bytes);

/// Forces a file, or the names in a folder, to the disk.
/// @throws FileError if it cannot be opened, or the disk refuses
void synchronise(const std::string& path);

/// Writes a file as `writeFile` does, such that it survives a loss of power once the function has returned.
/// @throws FileError if it cannot be written, or be forced to the disk
void writeDurably(const std::string& path, std::string_view bytes);

/// The text of a file, without the mark of UTF-8 at its start.
/// @throws as `readFile`; FileError as `utf8Text`
std::string readTextFile(const std::string& path);

/// The whole file as bytes.
/// @throws FileError, Cancelled as `InputFile::readRest`
std::string readFile(const std::string& path);
/// The whole file as bytes, if these are at most `most_bytes`.
/// @throws FileError if there are more; FileError, Cancelled as `InputFile::read`
std::string readFile(const std::string& path, std::size_t most_bytes);

}  // namespace lamina
