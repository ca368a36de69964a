// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "job/settings/setting_probe.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina::test {

/// A part sliced by settings.
SlicedPart slicedBy(const std::string& part, const SettingTexts& set);

/// The toolpath of a part (`partFile`): its identity, volumes and orientations.
std::function<std::string(const SettingTexts& set)> toolpathOf(const std::string& part);

/// The programs that a part's job writes, each under its name, in files with that suffix.
std::function<std::string(const SettingTexts& set)> programOf(const std::string& part,
                                                              const std::string& suffix);

}  // namespace lamina::test
