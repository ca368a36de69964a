// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "job/settings/setting_probe.hpp"

namespace lamina::test {

// Of settings that only nodes have, by what they are about: what a node hands over to the core, and what
// the core makes of it.
std::vector<SettingProbe> jogProbes();
std::vector<SettingProbe> driveProbes();
std::vector<SettingProbe> servoProbes();
std::vector<SettingProbe> plcProbes();
std::vector<SettingProbe> guardProbes();
std::vector<SettingProbe> hostProbes();
std::vector<SettingProbe> processIoProbes();
std::vector<SettingProbe> pageProbes();
std::vector<SettingProbe> machineProbes();
std::vector<SettingProbe> watchProbes();
std::vector<SettingProbe> shownProbes();

}  // namespace lamina::test
