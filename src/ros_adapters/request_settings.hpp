// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "messages.hpp"

namespace lamina {

lamina_msgs::Setting settingMessage(const std::string& key, const std::string& value);

/// Sets what a request overrides, in order.
/// @throws InvalidConfig if a key is unknown, or a value lies outside its bounds
void applyRequest(SettingsSchema& schema, const std::vector<lamina_msgs::Setting>& settings);

}  // namespace lamina
