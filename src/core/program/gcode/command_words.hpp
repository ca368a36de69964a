// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// Whether a command begins with that code, and no further digit follows: isCommand("M104 S200", "M104").
inline bool isCommand(std::string_view command, std::string_view code) {
  return command.substr(0, code.size()) == code &&
         (command.size() == code.size() ||
          std::isdigit(static_cast<unsigned char>(command[code.size()])) == 0);
}

template <std::size_t count>
bool isAnyCommand(std::string_view command, const std::array<std::string_view, count>& codes) {
  return std::any_of(codes.begin(), codes.end(),
                     [command](std::string_view code) { return isCommand(command, code); });
}

/// The number at the front of a text, behind blanks. It has no exponent: an E begins the next word.
inline std::optional<double> wordNumber(std::string_view text) {
  constexpr std::size_t kMostDigits = 32;
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const std::string number(text.substr(0, std::min(text.find_first_not_of("+-.0123456789"), kMostDigits)));
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  return end == number.c_str() ? std::nullopt : std::optional<double>(value);
}

/// The number after a letter that begins a word, behind a blank or the number of another word:
/// wordValue("M104 S200", 'S'), wordValue("M104S200", 'S').
inline std::optional<double> wordValue(std::string_view command, char letter) {
  for (std::size_t at = command.find(letter); at != std::string_view::npos;
       at = command.find(letter, at + 1)) {
    const char before = at == 0 ? letter : command[at - 1];
    const bool begins_word =
        before == ' ' || before == '.' || std::isdigit(static_cast<unsigned char>(before)) != 0;
    if (begins_word) return wordNumber(command.substr(at + 1));
  }
  return std::nullopt;
}

}  // namespace lamina
