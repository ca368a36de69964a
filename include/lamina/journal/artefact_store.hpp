// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// Files by the digest of their bytes and the suffix of their names, in a folder beside the journal;
/// read-only once they are there.
class ArtefactStore {
 public:
  /// Makes the folder if it is missing, for its owner alone.
  /// @throws FileError if it cannot be made
  explicit ArtefactStore(std::string folder);

  ArtefactStore(ArtefactStore&&) noexcept;
  ~ArtefactStore();

  /// A store that is looked at only: nothing is made.
  static ArtefactStore toRead(std::string folder);

  /// Copies a file into the store, durably, and gives what it is known by. The same bytes are kept once.
  /// @throws FileError if the file cannot be read or the store not written
  Artefact keep(const std::string& path, const std::string& kind, const std::string& name);

  /// Keeps bytes as `keep` does those of a file.
  Artefact keepText(const std::string& bytes, const std::string& kind, const std::string& name);

  /// Where the bytes of an artefact are.
  std::string pathOf(const Artefact& artefact) const;

  /// The names of those whose file is gone, or no longer has its digest. A file is read once, and again when
  /// its size or one of its times has changed.
  std::vector<std::string> torn(const std::vector<Artefact>& artefacts) const;

 private:
  class ReadFiles;
  ArtefactStore();

  std::string folder_;
  std::unique_ptr<ReadFiles> read_;
};

}  // namespace lamina
