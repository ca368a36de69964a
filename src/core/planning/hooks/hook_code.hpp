// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "lamina/base/placeholders.hpp"
#include "lamina/planning/hooks/hook_settings.hpp"

namespace lamina {

/// Code and the key of its setting.
struct HookCode {
  std::string key;
  std::string code;
};

/// All code that is not empty.
std::vector<HookCode> hookCodes(const HookSettings& settings);

/// Code for layers, by the index of the layer or by its height [mm].
/// @throws InvalidConfig if a name is no number of a layer, or no height
std::map<std::size_t, HookCode> layerHooks(const HookSettings& settings);
std::map<double, HookCode> heightHooks(const HookSettings& settings);

/// Whether code holds one of these placeholders.
bool holdsAny(const std::string& code, const std::vector<std::string>& placeholders);

/// Refuses unknown placeholders in code.
/// @throws InvalidConfig naming the setting
void requirePlaceholders(const std::string& key, const std::string& code);

}  // namespace lamina
