// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "lamina/job/voids/program_void_job.hpp"
#include "messages.hpp"

namespace lamina {

lamina_msgs::VoidFillingSummary toMessage(const ProgramVoidReport& report);

/// Each void of each layer.
std::vector<lamina_msgs::FilledVoid> toMessages(const ProgramVoidReport& report);

/// Of drops the new ones as spheres, of beads lines round the voids that were found; one namespace per class
/// of void. The first marker deletes those of an earlier program.
visualization_msgs::MarkerArray voidMarkers(const ProgramVoidReport& report, const std::string& frame);

}  // namespace lamina
