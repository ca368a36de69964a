// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// A correction map that a layer was laid by.
struct AppliedMap {
  std::uint64_t layer = 0;
  std::string digest;  ///< 16 hexadecimal digits

  bool operator==(const AppliedMap& other) const { return layer == other.layer && digest == other.digest; }
};

/// Where it is kept what a program was corrected by on its way, and how.
struct RevisionRecord {
  std::string folder;    ///< its absolute path
  std::string job;       ///< that no other one is called
  std::string settings;  ///< that count besides the maps, as text
};

/// What a corrected program was made from. From this and the maps it can be made again.
struct ProgramOrigin {
  std::string program_sha256;    ///< of the program without corrections, 64 hexadecimal digits
  std::vector<AppliedMap> maps;  ///< by layer, ascending
  /// That the maps are of, where a record says which of them were applied.
  std::optional<RevisionRecord> record = std::nullopt;
};

}  // namespace lamina
