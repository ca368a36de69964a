// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

struct JobSettings;

/// Settings that profiles state for layers in parallel planes, and that layers of other shapes leave out.
struct GivingWay {
  std::set<std::string> keys;      ///< keys that may be left out, since nobody typed them
  std::vector<std::string> notes;  ///< notes for the user on what was left out, a sentence each
};

/// The keys that may give way (combing, wiping and shrinkage), without typed keys.
std::set<std::string> keysGivingWay(const std::set<std::string>& typed);

/// Settings of `settings.giving_way.keys` that the slicing mode does not support, with the value that
/// switches them off. None for plane layers, and none for `auto`, as the function is called for each mode
/// that `auto` tries; with `conformal.base`, `auto` counts as `conformal`.
std::vector<SettingText> leftOut(const JobSettings& settings);

/// The settings without `leftOut`, with a note on each.
JobSettings withoutLeftOut(JobSettings settings);

/// Note on a setting that was left out.
std::string noteOnLeftOut(const SettingText& left_out, const std::string& mode);

}  // namespace lamina
