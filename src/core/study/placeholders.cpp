// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/placeholders.hpp"

#include <functional>
#include <string_view>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isInside(char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '.'; }

/// The name in braces at this place; empty if there is none.
std::string nameAt(const std::string& text, std::size_t at) {
  if (text[at] != '{' || at + 1 >= text.size() || !isLetter(text[at + 1])) return {};
  std::size_t end = at + 1;
  while (end < text.size() && isInside(text[end])) ++end;
  return end < text.size() && text[end] == '}' ? text.substr(at + 1, end - at - 1) : std::string();
}

/// Hears of every piece of the text: what stands for itself, and names.
void walk(const std::string& text, const std::function<void(char)>& plain,
          const std::function<void(const std::string&)>& name) {
  for (std::size_t at = 0; at < text.size();) {
    const std::string found = nameAt(text, at);
    if (found.empty()) {
      plain(text[at++]);
    } else {
      name(found);
      at += found.size() + 2;
    }
  }
}

}  // namespace

std::vector<std::string> placeholdersIn(const std::string& text) {
  std::vector<std::string> names;
  walk(
      text, [](char) {}, [&](const std::string& name) { names.push_back(name); });
  return names;
}

std::string filledIn(const std::string& text, const std::map<std::string, std::string>& values) {
  std::string filled;
  walk(
      text, [&](char c) { filled += c; },
      [&](const std::string& name) {
        const auto found = values.find(name);
        if (found == values.end()) throw InvalidConfig("'{" + name + "}' has no value in '" + text + "'");
        filled += found->second;
      });
  return filled;
}

}  // namespace lamina
