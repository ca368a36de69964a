// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "job/settings/setting_probe.hpp"

namespace lamina::test {

// Start-ups and streams on emulated machines over pseudo-terminals, in wall time; each ends as soon as the
// answer is known.

/// The last command that a machine has run of a start-up that is aborted while its bed heats.
std::string lastAfterAbort(const SettingTexts& set);

/// Whether an idle machine is looked at more than twice within a second.
std::string looksInASecond(const SettingTexts& set);

/// Whether drying ends within a second.
std::string driedInASecond(const SettingTexts& set);

/// How a job ends whose machine is unplugged for a while, and has half a second for its safe stop.
std::string unplugged(const SettingTexts& set);

}  // namespace lamina::test
