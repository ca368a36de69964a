// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/profiles/profile_suggestion.hpp"

#include <algorithm>
#include <string_view>

#include "lamina/base/edit_distance.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLeastHeld = 2;  // letters: a single one is in most names

bool isDigit(char letter) { return letter >= '0' && letter <= '9'; }
bool isSmall(char letter) { return letter >= 'a' && letter <= 'z'; }
bool isCapital(char letter) { return letter >= 'A' && letter <= 'Z'; }

std::string bareOf(std::string_view name) {
  std::string bare;
  for (const char letter : name) {
    if (isDigit(letter) || isSmall(letter)) bare += letter;
    if (isCapital(letter)) bare += static_cast<char>(letter - 'A' + 'a');
  }
  return bare;
}

}  // namespace

std::string profileSuggestion(const std::vector<std::string>& names, const std::string& given) {
  const std::string bare = bareOf(given);
  if (bare.empty()) return "";
  const std::string* held = nullptr;
  const std::string* nearest = nullptr;
  std::size_t least = 0;
  for (const std::string& name : names) {
    const std::string bare_name = bareOf(name);
    if (bare.size() >= kLeastHeld && bare_name.find(bare) != std::string::npos &&
        (held == nullptr || name.size() < held->size()))
      held = &name;
    const std::size_t distance = editDistance(bare_name, bare);
    const bool is_like = 2 * distance <= std::max(bare_name.size(), bare.size());
    if (!is_like || (nearest != nullptr && distance >= least)) continue;
    nearest = &name;
    least = distance;
  }
  if (held != nullptr) nearest = held;
  return nearest != nullptr ? "; did you mean '" + *nearest + "'?" : "";
}

}  // namespace lamina
