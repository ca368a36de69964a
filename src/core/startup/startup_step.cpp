// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/startup_step.hpp"

#include <algorithm>
#include <array>

namespace lamina {
namespace {

constexpr std::array<const char*, kStartupStepCount> kNames = {
    "power_on",    "dry_pellets", "heat_bed",     "home_x",      "home_y",          "home_z",
    "place_sheet", "draw_vacuum", "home_z_again", "map_heights", "transfer_program"};

}  // namespace

const char* toString(StartupStep step) { return kNames.at(static_cast<std::size_t>(step)); }

const std::vector<StartupStep>& allStartupSteps() {
  static const std::vector<StartupStep> kAll = [] {
    std::vector<StartupStep> steps;
    for (std::size_t i = 0; i < kStartupStepCount; ++i) steps.push_back(static_cast<StartupStep>(i));
    return steps;
  }();
  return kAll;
}

std::optional<StartupStep> startupStepFromText(const std::string& name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<StartupStep>(found - kNames.begin());
}

std::optional<char> homedAxis(StartupStep step) {
  switch (step) {
    case StartupStep::HomeX:
      return 'X';
    case StartupStep::HomeY:
      return 'Y';
    case StartupStep::HomeZ:
    case StartupStep::HomeZAgain:
      return 'Z';
    default:
      return std::nullopt;
  }
}

const char* toString(StartupState state) {
  constexpr std::array<const char*, 5> kStates = {"Pending", "Running", "Done", "Failed", "Skipped"};
  return kStates.at(static_cast<std::size_t>(state));
}

}  // namespace lamina
