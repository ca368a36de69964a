// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/placeholders.hpp"

#include <sstream>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// @return the line, empty if it is to be left out
std::string expandLine(const std::string& key, std::string line, const PlaceholderValue& value) {
  for (std::size_t open = line.find('{'); open != std::string::npos; open = line.find('{', open)) {
    const std::size_t close = line.find('}', open);
    if (close == std::string::npos)
      throw InvalidConfig(key + " has '{' without '}' in the line '" + line + "'");
    const std::string text = value(line.substr(open + 1, close - open - 1));
    if (text.empty()) return "";
    line.replace(open, close - open + 1, text);
    open += text.size();
  }
  return line + "\n";
}

}  // namespace

std::string expandPlaceholders(const std::string& key, const std::string& lines,
                               const PlaceholderValue& value) {
  std::istringstream rest(lines);
  std::string expanded;
  for (std::string line; std::getline(rest, line);) expanded += expandLine(key, std::move(line), value);
  return expanded;
}

}  // namespace lamina
