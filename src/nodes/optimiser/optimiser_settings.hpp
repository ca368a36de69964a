// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kriging/kriging.hpp"
#include "lamina/study/search_settings.hpp"

namespace lamina {

/// Search settings for studies that do not state their own.
struct OptimiserSettings {
  SearchSettings search;
  KrigingSettings kriging;
};

/// Adds the keys nsga2.*, surrogate.*, genetic.* and kriging.*.
void describe(SettingsSchema& schema, OptimiserSettings& settings);

/// The settings that differ from the defaults, in the form of a study.
std::vector<SettingText> searchTexts(OptimiserSettings settings);

}  // namespace lamina
