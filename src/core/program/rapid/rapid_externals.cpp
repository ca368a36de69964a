// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/rapid_externals.hpp"

#include <algorithm>

#include "kinematics/model/external_joint.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "program/external_entries.hpp"

namespace lamina {
namespace {

const ExternalNaming& rapidNaming() {
  static const ExternalNaming naming{"rapid.external_axes", "eax_", 'a',
                                     "external_1=eax_b, or external_2=-eax_c+90"};
  return naming;
}

}  // namespace

std::string rapidAxisName(std::size_t slot) { return rapidNaming().nameOf(slot); }

std::vector<RapidExternal> rapidExternals(const std::string& text) {
  std::vector<RapidExternal> externals;
  for (const ExternalEntry& entry : externalEntries(text, rapidNaming()))
    externals.push_back({entry.joint, entry.slot, entry.sign, entry.zero});
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
