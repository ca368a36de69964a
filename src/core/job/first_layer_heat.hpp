// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/job/plate/plate_settings.hpp"
#include "lamina/planning/compensation/compensation_settings.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The program's settings with the first layer's temperatures in place of its own, where the first layer has
/// any (0: none).
/// @throws InvalidConfig if the first layer has a temperature whose placeholder is missing in the start code
ProgramSettings startedFor(const FirstLayerSettings& first_layer, ProgramSettings settings);

/// Adds commands for the program's temperatures, without a wait, before the second layer that has paths, if
/// those of the first layer differ. If parts are printed one after the other, the first layer of each part
/// has the first layer's temperatures.
void addHeatAfterFirstLayer(Toolpath& toolpath, const FirstLayerSettings& first_layer,
                            const ProgramSettings& settings, PlateOrder order);

}  // namespace lamina
