// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/program/rapid/rapid_settings.hpp"
#include "program/rapid/rapid_words.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostLevels = 7;  // a move has 8 triggers, one of them the wire's
constexpr double kLeastPer = 1e-12;

RapidLevel rapidLevelOf(std::string_view entry) {
  const std::size_t equals = std::min(entry.find('='), entry.size());
  const std::size_t times = entry.find('*', equals);
  RapidLevel level;
  level.name = std::string(trimmed(entry.substr(0, equals)));
  bool is_read =
      times != std::string_view::npos && !level.name.empty() && level.name.find(' ') == std::string::npos;
  if (is_read) {
    level.signal = std::string(trimmed(entry.substr(equals + 1, times - equals - 1)));
    const std::string_view per = trimmed(entry.substr(times + 1));
    const auto read = std::from_chars(per.data(), per.data() + per.size(), level.per);
    is_read = read.ec == std::errc() && read.ptr == per.data() + per.size() &&
              std::abs(level.per) >= kLeastPer && std::isfinite(level.per);
  }
  if (!is_read)
    throw InvalidConfig("rapid.levels holds '" + std::string(entry) +
                        "'; expected value=signal*per, as laser_power_w=aoLaser*0.0025");
  requireRapidName("rapid.levels", level.signal);
  return level;
}

}  // namespace

std::vector<RapidLevel> rapidLevels(const std::string& text) {
  std::vector<RapidLevel> levels;
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    RapidLevel level = rapidLevelOf(trimmed(rest.substr(0, comma)));
    for (const RapidLevel& other : levels)
      if (other.name == level.name || lowerCase(other.signal) == lowerCase(level.signal))
        throw InvalidConfig("rapid.levels names '" + level.name + "' at " + level.signal + " after '" +
                            other.name + "' at " + other.signal + "; must differ");
    levels.push_back(std::move(level));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  if (levels.size() > kMostLevels)
    throw InvalidConfig("rapid.levels has " + std::to_string(levels.size()) + " values; expected " +
                        std::to_string(kMostLevels) + " at most: a move takes 8 triggers");
  return levels;
}

}  // namespace lamina
