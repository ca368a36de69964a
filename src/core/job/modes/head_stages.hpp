// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/slicing/volumetric/head_room.hpp"

namespace lamina {

/// The pieces of a machine's or robot's head that turn with the nozzle, as solids of revolution about the
/// tool axis that enclose them. None if the nozzle has no body.
/// @throws FileError, InvalidConfig as `kinematicModelOf`
std::vector<HeadStage> headStages(const MachineSettings& machine);

}  // namespace lamina
