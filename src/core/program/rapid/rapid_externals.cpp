// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/rapid_externals.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "kinematics/model/external_joint.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::string_view kAxis = "eax_";
constexpr double kGreatestZero = 1e5;  // mm, deg

/// What follows the axis: nothing, or a number with its sign.
bool readZero(std::string_view text, double& zero) {
  if (text.empty()) return true;
  if (text.front() != '+' && text.front() != '-') return false;
  if (text.front() == '+') text.remove_prefix(1);
  const auto read = std::from_chars(text.data(), text.data() + text.size(), zero);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() && std::abs(zero) <= kGreatestZero;
}

RapidExternal rapidExternalOf(std::string_view entry) {
  const std::size_t equals = std::min(entry.find('='), entry.size());
  RapidExternal external;
  external.joint = std::string(trimmed(entry.substr(0, equals)));
  std::string_view axis = trimmed(entry.substr(std::min(equals + 1, entry.size())));
  if (!axis.empty() && axis.front() == '-') {
    external.sign = -1.0;
    axis.remove_prefix(1);
  }
  const bool is_axis = axis.size() > kAxis.size() && lowerCase(axis.substr(0, kAxis.size())) == kAxis;
  const char letter = is_axis ? lowerCase(axis.substr(kAxis.size(), 1)).front() : '\0';
  if (external.joint.empty() || letter < 'a' || letter > 'f' ||
      !readZero(axis.substr(kAxis.size() + 1), external.zero))
    throw InvalidConfig("rapid.external_axes holds '" + std::string(entry) +
                        "'; expected joint=axis, as external_1=eax_b, or external_2=-eax_c+90");
  external.slot = static_cast<std::size_t>(letter - 'a');
  return external;
}

}  // namespace

std::string rapidAxisName(std::size_t slot) {
  return std::string(kAxis) + static_cast<char>('a' + static_cast<int>(slot));
}

std::vector<RapidExternal> rapidExternals(const std::string& text) {
  std::vector<RapidExternal> externals;
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    RapidExternal external = rapidExternalOf(trimmed(rest.substr(0, comma)));
    for (const RapidExternal& other : externals)
      if (other.joint == external.joint || other.slot == external.slot)
        throw InvalidConfig("rapid.external_axes names " + external.joint + " at " +
                            rapidAxisName(external.slot) + " after " + other.joint + " at " +
                            rapidAxisName(other.slot) + "; must differ");
    externals.push_back(std::move(external));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return externals;
}

std::vector<RapidExternal> externalsOf(const KinematicModel& arm, const std::string& text) {
  std::vector<RapidExternal> named = rapidExternals(text);
  if (named.empty()) return {};
  std::vector<RapidExternal> externals;
  std::vector<std::string> joints;
  for (const DrivenJoint& joint : arm.joints()) {
    if (!isExternal(joint.name)) continue;
    joints.push_back(joint.name);
    const auto found = std::find_if(named.begin(), named.end(),
                                    [&](const RapidExternal& each) { return each.joint == joint.name; });
    if (found == named.end())
      throw InvalidConfig("rapid.external_axes is '" + text + "', without joint " + joint.name + " of '" +
                          arm.name() + "'; expected an axis for each external joint");
    externals.push_back(*found);
  }
  for (const RapidExternal& each : named)
    if (std::find(joints.begin(), joints.end(), each.joint) == joints.end())
      throw InvalidConfig("rapid.external_axes names joint " + each.joint + "; expected one of '" +
                          arm.name() +
                          "': " + (joints.empty() ? "it has no external joints" : listed(joints)));
  return externals;
}

}  // namespace lamina
