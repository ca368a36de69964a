// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "request_settings.hpp"

namespace lamina {

lamina_msgs::Setting settingMessage(const std::string& key, const std::string& value) {
  lamina_msgs::Setting message;
  message.key = key;
  message.value = value;
  return message;
}

void applyRequest(SettingsSchema& schema, const std::vector<lamina_msgs::Setting>& settings) {
  for (const lamina_msgs::Setting& setting : settings) schema.set(setting.key, setting.value);
}

}  // namespace lamina
