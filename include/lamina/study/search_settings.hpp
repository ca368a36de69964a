// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/nsga2.hpp"
#include "lamina/optimisation/surrogate_search.hpp"
#include "lamina/study/study.hpp"

namespace lamina {

/// How either method searches.
struct SearchSettings {
  Nsga2Settings nsga2;
  SurrogateSearchSettings surrogate;
};

/// Adds the keys nsga2.*, surrogate.* and genetic.*.
void describe(SettingsSchema& schema, SearchSettings& settings);

/// Whether a key is for what fits surrogates, which the core does not know: kriging.*.
bool isOfSurrogateFit(const std::string& key);

/// The settings of a study: the defaults, then what stands under `search`, in order. A study of
/// a table alone waits for somebody to measure what is proposed.
/// @throws InvalidConfig naming key, value and bound; keys of the surrogate fit are passed over
SearchSettings searchSettingsOf(const Study& study);

/// What stands under `search` for what fits surrogates.
std::vector<SettingText> surrogateFitSettingsOf(const Study& study);

}  // namespace lamina
