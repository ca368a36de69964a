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
  std::string digest;  ///< 16 hexadecimal digits

  bool operator==(const AppliedMap& other) const { return layer == other.layer && digest == other.digest; }
};

/// The place of the record of maps by which a program was corrected while it was sent.
struct RevisionRecord {
  std::string folder;    ///< absolute path
  std::string job;       ///< unique name of the job
  std::string settings;  ///< other settings of the corrections, as text
};

/// The origin of a corrected program, from which it can be made again together with the maps.
struct ProgramOrigin {
  std::string program_sha256;    ///< of the program without corrections, 64 hexadecimal digits
  std::vector<AppliedMap> maps;  ///< by layer, ascending
  /// The record of which maps were applied, if there is one.
  std::optional<RevisionRecord> record = std::nullopt;
};

}  // namespace lamina
