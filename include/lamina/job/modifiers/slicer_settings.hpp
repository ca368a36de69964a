// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// Settings of another slicer, translated into those of Lamina.
struct TranslatedSettings {
  std::vector<SettingText> settings;
  std::vector<std::string> left_out;  ///< settings that a region cannot have here, with their values, quoted
};

/// Translates the settings that PrusaSlicer, OrcaSlicer, Bambu Studio and, with the prefix `cura:`, Cura
/// write for an object, a volume or a range of heights: walls, density, pattern and direction of the infill,
/// skins, feeds, flows and tools. A feed in percent refers to a feed of the region or, if that is not set, of
/// the part. Tools count from 1, in Cura from 0; 0, in Cura a negative number, stands for the tool of the
/// part. A layer height equal to the part's is ignored. A solid infill becomes a zigzag unless its pattern is
/// stated. Settings without a counterpart are left out, and so are invalid values, unknown patterns and tools
/// that do not exist.
/// @param of_slicer  keys and values as in the file; keys that state where a volume came from are ignored
/// @param of_part    settings that hold around the region
TranslatedSettings translated(const std::vector<SettingText>& of_slicer, const JobSettings& of_part);

}  // namespace lamina
