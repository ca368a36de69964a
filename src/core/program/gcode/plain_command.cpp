// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/plain_command.hpp"

#include <cstddef>

namespace lamina {
namespace {

constexpr std::string_view kDigits = "0123456789";

/// Takes what comes first in the text of these characters.
std::string_view takeAny(std::string_view& text, std::string_view characters) {
  const std::string_view taken = text.substr(0, text.find_first_not_of(characters));
  text.remove_prefix(taken.size());
  return taken;
}

bool takeLetter(std::string_view& text, std::string_view letters) {
  if (text.empty() || letters.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

bool takeNumber(std::string_view& text) {
  takeLetter(text, "+-");
  const std::size_t whole = takeAny(text, kDigits).size();
  const std::size_t fraction = takeLetter(text, ".") ? takeAny(text, kDigits).size() : 0;
  return whole + fraction > 0;
}

void skipSpace(std::string_view& text) { takeAny(text, " \t\r"); }

bool isWord(std::string_view& text) {
  if (takeLetter(text, "XYZExyze")) {
    takeNumber(text);
    return true;
  }
  return takeLetter(text, "ABCDFGHIJKLMNOPQRSTUVWabcdfghijklmnopqrstuvw") && takeNumber(text);
}

}  // namespace

bool isPlainCommand(std::string_view line) {
  skipSpace(line);
  if (takeLetter(line, "Nn")) takeNumber(line);
  skipSpace(line);
  if (!takeLetter(line, "GMgm") || !takeNumber(line)) return false;
  for (skipSpace(line); !line.empty() && line.front() != ';' && line.front() != '*'; skipSpace(line))
    if (!isWord(line)) return false;
  return true;
}

}  // namespace lamina
