// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/text.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "lamina/base/characters.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::string_view kSpace = " \t\r\n\f\v";

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::string_view withoutUtf8Mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.substr(0, kMark.size()) == kMark) text.remove_prefix(kMark.size());
  return text;
}

std::string_view utf8Text(std::string_view bytes, const std::string& source) {
  const std::string_view start = bytes.substr(0, 2);
  if (start == "\xFF\xFE" || start == "\xFE\xFF")
    throw FileError("cannot read '" + source + "': it is text in UTF-16; expected UTF-8, as editors save it");
  return withoutUtf8Mark(bytes);
}

std::string lowerCase(std::string_view text) {
  std::string small(text);
  for (char& letter : small) letter = lower(letter);
  return small;
}

std::string smallSuffix(const std::string& path) {
  return lowerCase(std::filesystem::path(path).extension().string());
}

std::vector<std::string> listEntries(std::string_view list) {
  std::vector<std::string> entries;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view entry = trimmed(list.substr(0, comma));
    if (!entry.empty()) entries.emplace_back(entry);
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return entries;
}

std::string listed(const std::vector<std::string>& names, std::string_view separator) {
  std::string list;
  for (const std::string& name : names) {
    if (&name != &names.front()) list += separator;
    list += name;
  }
  return list;
}

std::vector<std::string> splitIntoWords(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string countedSubject(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? " was" : "s were");
}

std::vector<std::string> brokenInto(std::size_t longest_line, const std::string& text) {
  std::vector<std::string> lines(1);
  for (const std::string& word : splitIntoWords(text)) {
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > longest_line) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

}  // namespace lamina
