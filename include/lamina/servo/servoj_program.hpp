// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/servo/servoj_settings.hpp"

namespace lamina {

/// The URScript program by which a robot of Universal Robots follows targets. It opens a socket to this host,
/// reads target frames (`targetBytes`), moves the joints by servoj each cycle, and sends their positions
/// (`reportBytes`). If targets are late or lost, it continues towards `CyclicTarget::ahead` of the last one;
/// if none arrives for `silence_s`, it brakes by stopj and ends. Its count of cycles follows the numbers of
/// the targets slowly: their jitter does not reach the joints.
/// @param host  IPv4 address by which the robot reaches this host
/// @param port  TCP port of this host
std::string servojProgram(const ServojSettings& settings, const std::string& host, std::uint16_t port);

}  // namespace lamina
