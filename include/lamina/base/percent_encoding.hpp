// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// Text in which every byte but those of `kept`, letters and digits of ASCII is written as % and two
/// hexadecimal digits, capitals.
std::string percentEncoded(std::string_view text, std::string_view kept);

/// The text again; nothing if a % is not followed by two hexadecimal digits, capitals or not.
std::optional<std::string> percentDecoded(std::string_view text);

}  // namespace lamina
