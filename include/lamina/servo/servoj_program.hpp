// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/servo/servoj_settings.hpp"

namespace lamina {

/// The program in URScript that a robot of Universal Robots runs to be led by targets. It opens a socket to
/// this host, takes frames of targets (`targetBytes`), leads the joints by servoj each cycle and reports
/// where they are (`reportBytes`). Where targets are late or lost it goes on as they planned; after the
/// silence it brakes by stopj, and ends. Its own count of cycles follows that of the targets, so that their
/// jitter does not reach the joints.
/// @param host  address of this host, as the robot reaches it
std::string servojProgram(const ServojSettings& settings, const std::string& host, std::uint16_t port);

}  // namespace lamina
