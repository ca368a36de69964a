// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace lamina {

/// How a job starts.
enum class JobStart : std::uint8_t {
  New,  ///< at its first line; on a print server the program is uploaded and its print started
  /// Where the job of an earlier session left off. On a print server its running print is followed, and
  /// nothing is started.
  Resume,
};

}  // namespace lamina
