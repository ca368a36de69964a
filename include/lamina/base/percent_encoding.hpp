// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// The text with ASCII letters, ASCII digits and the bytes of `kept` as they are, and every other byte as %
/// and two capital hexadecimal digits.
std::string percentEncoded(std::string_view text, std::string_view kept);

/// The text that was encoded; nothing if a % is not followed by two hexadecimal digits, capitals or not.
std::optional<std::string> percentDecoded(std::string_view text);

}  // namespace lamina
