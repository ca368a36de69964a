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

/// Settings of both search methods.
struct SearchSettings {
  Nsga2Settings nsga2;
  SurrogateSearchSettings surrogate;
};

/// Adds the keys nsga2.*, surrogate.* and genetic.*.
void describe(SettingsSchema& schema, SearchSettings& settings);

/// Whether a key belongs to the fit of surrogates, which is not part of the core: kriging.*.
bool isOfSurrogateFit(const std::string& key);

/// The search settings of a study: the defaults, changed by the entries of `Study::search` in their order.
/// For a study with a table alone the search stops at a point that is not in the table and has to be
/// measured. Keys of the surrogate fit are ignored.
/// @throws InvalidConfig naming key, value and bound
SearchSettings searchSettingsOf(const Study& study);

/// The entries of `Study::search` that belong to the fit of surrogates.
std::vector<SettingText> surrogateFitSettingsOf(const Study& study);

}  // namespace lamina
