// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kriging/kriging.hpp"
#include "lamina/study/search_settings.hpp"

namespace lamina {

/// How studies are searched that do not say it themselves.
struct OptimiserSettings {
  SearchSettings search;
  KrigingSettings kriging;
};

/// Adds the keys nsga2.*, surrogate.*, genetic.* and kriging.*.
void describe(SettingsSchema& schema, OptimiserSettings& settings);

/// What of the settings differs from the defaults, as a study holds it.
std::vector<SettingText> searchTexts(OptimiserSettings settings);

}  // namespace lamina
