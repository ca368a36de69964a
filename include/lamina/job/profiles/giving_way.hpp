// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

struct JobSettings;

/// What profiles ask of layers in parallel planes, and layers of other shapes go without.
struct GivingWay {
  std::set<std::string> keys;      ///< keys that may be left out, since nobody typed them
  std::vector<std::string> notes;  ///< notes for the user on what was left out, a sentence each
};

/// The keys that may give way, combing, wiping and shrinkage, without those that were typed.
std::set<std::string> keysGivingWay(const std::set<std::string>& typed);

/// Those of `settings.giving_way.keys` that ask for something the slicing mode does not have, with the value
/// that asks for nothing. None for plane layers, nor for `auto`, which asks for each mode that it tries; but
/// with `conformal.base`, `auto` counts as `conformal`.
std::vector<SettingText> leftOut(const JobSettings& settings);

/// The settings without `leftOut`, with a note on each.
JobSettings withoutLeftOut(JobSettings settings);

/// Note on one that was left out.
std::string noteOnLeftOut(const SettingText& left_out, const std::string& mode);

}  // namespace lamina
