// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/giving_way.hpp"

#include "lamina/job/job_settings.hpp"
#include "lamina/job/modes/slicing_mode.hpp"

namespace lamina {
namespace {

constexpr const char* kComb = "travel.comb";
constexpr const char* kWipe = "travel.wipe_mm";
constexpr const char* kShrinkAcross = "compensation.shrink_xy";
constexpr const char* kShrinkUp = "compensation.shrink_z";

/// With a base there is nothing to choose.
std::string modeOf(const JobSettings& settings) {
  const bool is_on_base = settings.slicing.mode == kAutoMode && !settings.conformal.base.empty();
  return is_on_base ? "conformal" : settings.slicing.mode;
}

}  // namespace

std::set<std::string> keysGivingWay(const std::set<std::string>& typed) {
  std::set<std::string> keys = {kComb, kWipe, kShrinkAcross, kShrinkUp};
  for (const std::string& key : typed) keys.erase(key);
  return keys;
}

std::vector<SettingText> leftOut(const JobSettings& settings) {
  const std::string mode = modeOf(settings);
  if (mode == kAutoMode || hasPlaneLayers(mode)) return {};
  std::vector<SettingText> left_out;
  const auto leaveOut = [&](const char* key, bool is_asked, const char* none) {
    if (is_asked && settings.giving_way.keys.count(key) != 0) left_out.push_back({key, none});
  };
  leaveOut(kComb, settings.planning.travel.comb != Combing::None, "none");
  leaveOut(kWipe, settings.planning.travel.wipe_mm != 0.0, "0");
  if (slicingModes().find(mode).deposited_on == DepositedOn::Bed) return left_out;
  leaveOut(kShrinkAcross, settings.compensation.shrink_xy != 0.0, "0");
  leaveOut(kShrinkUp, settings.compensation.shrink_z != 0.0, "0");
  return left_out;
}

JobSettings withoutLeftOut(JobSettings settings) {
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& each : leftOut(settings)) {
    settings.giving_way.notes.push_back(noteOnLeftOut(each, modeOf(settings)));
    schema.set(each.key, each.text);
  }
  return settings;
}

std::string noteOnLeftOut(const SettingText& left_out, const std::string& mode) {
  return left_out.key + " of the profile is left out, as '" + left_out.text + "': layers of slicing.mode '" +
         mode + "' do not have it";
}

}  // namespace lamina
