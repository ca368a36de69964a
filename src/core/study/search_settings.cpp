// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/search_settings.hpp"

#include <algorithm>
#include <iterator>

namespace lamina {

void describe(SettingsSchema& schema, SearchSettings& settings) {
  describe(schema, settings.nsga2);
  describe(schema, settings.surrogate);
}

bool isOfSurrogateFit(const std::string& key) { return key.rfind("kriging.", 0) == 0; }

SearchSettings searchSettingsOf(const Study& study) {
  SearchSettings settings;
  if (!study.slice && !study.commands) settings.surrogate.failed_proposal = FailedProposal::Stop;
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& setting : study.search)
    if (!isOfSurrogateFit(setting.key)) schema.set(setting.key, setting.text);
  schema.validate();
  requireConsistent(settings.surrogate);
  return settings;
}

std::vector<SettingText> surrogateFitSettingsOf(const Study& study) {
  std::vector<SettingText> found;
  std::copy_if(study.search.begin(), study.search.end(), std::back_inserter(found),
               [](const SettingText& setting) { return isOfSurrogateFit(setting.key); });
  return found;
}

}  // namespace lamina
