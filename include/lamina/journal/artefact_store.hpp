// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// A file that was taken into the store.
struct KeptFile {
  Artefact artefact;
  bool is_new = false;  ///< whether the store had no file with these bytes and that suffix
};

/// Store of files, named by the digest of their bytes and the suffix of their original name, in a folder
/// beside the journal. They are read-only once they are stored.
class ArtefactStore {
 public:
  /// Opens a store; makes its folder if it is missing, accessible by its owner alone.
  /// @throws FileError if the folder cannot be made
  explicit ArtefactStore(std::string folder);

  ArtefactStore(ArtefactStore&&) noexcept;
  ~ArtefactStore();

  /// Opens a store for reading only: no folder is made.
  static ArtefactStore toRead(std::string folder);

  /// Copies a file into the store, durably. Files with the same bytes are stored once.
  /// @return the artefact by which it is found again
  /// @throws FileError if the file cannot be read or the store cannot be written
  Artefact keep(const std::string& path, const std::string& kind, const std::string& name);

  /// Stores a file as `keep` does, and also returns whether it is a new one. If it throws, no new file is
  /// left.
  KeptFile keepFile(const std::string& path, const std::string& kind, const std::string& name);

  /// Removes the file of an artefact that no row of the journal names.
  void remove(const Artefact& artefact);

  /// Stores bytes from memory; otherwise as `keep`.
  Artefact keepText(const std::string& bytes, const std::string& kind, const std::string& name);

  /// Path of an artefact's file.
  std::string pathOf(const Artefact& artefact) const;

  /// Names of the artefacts whose file is missing or does not have its digest. A file is read once, and again
  /// if its size or one of its times has changed.
  std::vector<std::string> torn(const std::vector<Artefact>& artefacts) const;

 private:
  class ReadFiles;
  ArtefactStore();

  std::string folder_;
  std::unique_ptr<ReadFiles> read_;
};

}  // namespace lamina
