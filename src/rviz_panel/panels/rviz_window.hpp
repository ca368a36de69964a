// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/config.h>
#include <rviz/panel.h>
#include <rviz/view_manager.h>

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Leads the camera to a box [mm] from where it looks now, if it is one that orbits.
void lookAt(rviz::ViewManager& views, const Box3& box);

/// Puts all that a panel holds into it, with bars to scroll where it is too small.
void addScrolled(rviz::Panel& panel, QWidget& content);

/// What RViz's configuration holds of these keys; absent ones are left out.
std::vector<SettingText> savedTexts(const rviz::Config& config, const std::vector<SettingText>& keys);
void saveTexts(rviz::Config config, const std::vector<SettingText>& texts);

}  // namespace lamina
