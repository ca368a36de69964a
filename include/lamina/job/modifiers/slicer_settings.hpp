// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// Settings of another slicer by the names that they have here.
struct TranslatedSettings {
  std::vector<SettingText> settings;
  std::vector<std::string> left_out;  ///< those that a region cannot have here, with their values, quoted
};

/// Translates what PrusaSlicer, OrcaSlicer, Bambu Studio and, with the prefix `cura:`, Cura write of an
/// object, a volume or a range of heights: walls, density, pattern and direction of the infill, skins, feeds,
/// flows and tools. Shares of feeds refer to those of the region, or else of the part; tools count from 1 but
/// for Cura, and 0 is that of the part. The part's own layer height is passed over. A solid fill becomes a
/// zigzag unless its pattern is stated. What the part's settings give no meaning to is left out: values that
/// do not fit, patterns and tools that there are not.
/// @param of_slicer  keys and values as they stand in the file; what says where a volume came from is passed
///   over
/// @param of_part    what holds round the region
TranslatedSettings translated(const std::vector<SettingText>& of_slicer, const JobSettings& of_part);

}  // namespace lamina
