// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lamina {

/// A correction map that a layer was laid by.
struct AppliedMap {
  std::uint64_t layer = 0;
  std::string digest;  ///< 16 hexadecimal digits

  bool operator==(const AppliedMap& other) const { return layer == other.layer && digest == other.digest; }
};

/// What a corrected program was made from. From this and the maps it can be made again.
struct ProgramOrigin {
  std::string program_sha256;    ///< of the program without corrections, 64 hexadecimal digits
  std::vector<AppliedMap> maps;  ///< by layer, ascending
};

}  // namespace lamina
