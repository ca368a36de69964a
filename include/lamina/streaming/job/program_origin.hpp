// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// The correction map with which a layer was deposited.
struct AppliedMap {
  std::uint64_t layer = 0;
  std::string digest;  ///< of the map, 16 hexadecimal digits

  bool operator==(const AppliedMap& other) const { return layer == other.layer && digest == other.digest; }
};

/// Refers to the record of the correction maps by which a program was corrected while it was sent.
struct RevisionRecord {
  std::string folder;    ///< absolute path of the folder that holds the record
  std::string job;       ///< unique name of the job
  std::string settings;  ///< further settings on which the corrections depend, as text
};

/// What a corrected program was made from: the program without corrections, and the correction maps.
struct ProgramOrigin {
  std::string program_sha256;    ///< of the program without corrections, 64 hexadecimal digits
  std::vector<AppliedMap> maps;  ///< by layer, ascending
  /// The record of the maps that were applied; nothing if none was kept.
  std::optional<RevisionRecord> record = std::nullopt;
};

}  // namespace lamina
