// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings.hpp"

namespace lamina {

/// Settings as a YAML document that `settingsFromYaml` reads back, grouped by the first part of the key. Of
/// settings with one key, the last counts, in the place of the first.
std::string settingsToYaml(const std::vector<SettingText>& settings);

}  // namespace lamina
