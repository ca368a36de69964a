// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace lamina {

/// Bytes as base64 (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace lamina
