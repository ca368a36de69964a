// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimiser_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, OptimiserSettings& settings) {
  describe(schema, settings.search);
  describe(schema, settings.kriging);
}

std::vector<SettingText> searchTexts(OptimiserSettings settings) {
  OptimiserSettings usual;
  SettingsSchema schema;
  SettingsSchema usual_schema;
  describe(schema, settings);
  describe(usual_schema, usual);
  std::vector<SettingText> changed;
  for (std::size_t i = 0; i < schema.settings().size(); ++i) {
    const std::string text = schema.settings()[i].get();
    if (text != usual_schema.settings()[i].get()) changed.push_back({schema.settings()[i].key, text});
  }
  return changed;
}

}  // namespace lamina
