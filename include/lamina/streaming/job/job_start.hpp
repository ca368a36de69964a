// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace lamina {

/// How a job starts.
enum class JobStart : std::uint8_t {
  New,     ///< from its first line; at a print server the program is uploaded and its print started
  Resume,  ///< with the job of an earlier session; at a print server its print is followed, nothing is
           ///< started
};

}  // namespace lamina
