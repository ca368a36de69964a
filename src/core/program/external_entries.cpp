// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/external_entries.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr double kGreatestZero = 1e5;  // mm, deg
constexpr int kMostAxes = 6;           // of a controller

/// What follows the axis: nothing, or a number with its sign.
bool readZero(std::string_view text, double& zero) {
  if (text.empty()) return true;
  if (text.front() != '+' && text.front() != '-') return false;
  if (text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return false;
  }
  const auto read = std::from_chars(text.data(), text.data() + text.size(), zero);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() && std::abs(zero) <= kGreatestZero;
}

ExternalEntry externalEntryOf(std::string_view entry, const ExternalNaming& naming) {
  const std::size_t equals = std::min(entry.find('='), entry.size());
  ExternalEntry external;
  external.joint = std::string(trimmed(entry.substr(0, equals)));
  std::string_view axis = trimmed(entry.substr(std::min(equals + 1, entry.size())));
  if (!axis.empty() && axis.front() == '-') {
    external.sign = -1.0;
    axis.remove_prefix(1);
  }
  const std::size_t length = naming.prefix.size();
  const bool is_axis = axis.size() > length && lowerCase(axis.substr(0, length)) == naming.prefix;
  const int slot = is_axis ? lowerCase(axis.substr(length, 1)).front() - naming.first : -1;
  if (external.joint.empty() || slot < 0 || slot >= kMostAxes ||
      !readZero(axis.substr(length + 1), external.zero))
    throw InvalidConfig(naming.setting + " holds '" + std::string(entry) + "'; expected joint=axis, as " +
                        naming.example);
  external.slot = static_cast<std::size_t>(slot);
  return external;
}

}  // namespace

std::string ExternalNaming::nameOf(std::size_t slot) const {
  return prefix + static_cast<char>(first + static_cast<int>(slot));
}

std::vector<ExternalEntry> externalEntries(const std::string& text, const ExternalNaming& naming) {
  std::vector<ExternalEntry> externals;
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    ExternalEntry external = externalEntryOf(trimmed(rest.substr(0, comma)), naming);
    for (const ExternalEntry& other : externals)
      if (other.joint == external.joint || other.slot == external.slot)
        throw InvalidConfig(naming.setting + " names " + external.joint + " at " +
                            naming.nameOf(external.slot) + " after " + other.joint + " at " +
                            naming.nameOf(other.slot) + "; must differ");
    externals.push_back(std::move(external));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return externals;
}

}  // namespace lamina
