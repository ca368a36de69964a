// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// The number after a letter that stands after a space: wordValue("M104 S200", 'S').
inline std::optional<double> wordValue(std::string_view command, char letter) {
  for (std::size_t at = command.find(letter); at != std::string_view::npos;
       at = command.find(letter, at + 1)) {
    if (at == 0 || command[at - 1] != ' ') continue;
    const std::string number(command.substr(at + 1, 32));
    char* end = nullptr;
    const double value = std::strtod(number.c_str(), &end);
    return end == number.c_str() ? std::nullopt : std::optional<double>(value);
  }
  return std::nullopt;
}

}  // namespace lamina
