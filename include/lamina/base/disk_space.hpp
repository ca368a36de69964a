// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lamina {

/// Free space [bytes] for this user on the disk of a folder; nothing if the system does not report it, as for
/// a folder that does not exist or may not be entered.
std::optional<std::uint64_t> freeBytesOf(const std::string& folder);

}  // namespace lamina
