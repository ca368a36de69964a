// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/compensation/compensation_settings.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The program's settings with the temperatures that the first layer starts at.
/// @throws InvalidConfig if one is set that the start code has no place for
ProgramSettings startedFor(const FirstLayerSettings& first_layer, ProgramSettings settings);

/// Sets the program's temperatures before the second layer that has paths, without waiting, where the first
/// layer has others.
void addHeatAfterFirstLayer(Toolpath& toolpath, const FirstLayerSettings& first_layer,
                            const ProgramSettings& settings);

}  // namespace lamina
