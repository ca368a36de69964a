// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lamina {

/// Bytes that the disk of a folder has left for this user; nothing if the system does not say, as of a folder
/// that is not there or may not be entered.
std::optional<std::uint64_t> freeBytesOf(const std::string& folder);

}  // namespace lamina
