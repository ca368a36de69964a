// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/loopback.hpp"
#include "network/listening_ports.hpp"

namespace lamina {

/// How a node is announced, and which ports are there.
struct Exposure {
  std::string host;                      ///< that the node announces
  std::string master_uri;                ///< where its master is
  std::vector<std::uint16_t> own_ports;  ///< of the node, reachable from other hosts
  std::vector<ListeningPort> all_ports;  ///< of the node's host
};

/// What a user should know at the start of a node, a sentence each; none if other hosts reach nothing.
std::vector<std::string> exposureWarnings(const Exposure& exposure);

/// The host in the address of a ROS master: "robot" in "http://robot:11311/".
std::string hostOfMaster(const std::string& uri);

}  // namespace lamina
