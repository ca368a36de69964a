// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/loopback.hpp"
#include "network/listening_ports.hpp"

namespace lamina {

/// The addresses that a node announces, and the ports that are open on its host.
struct Exposure {
  std::string host;                      ///< host that the node announces
  std::string master_uri;                ///< address of its master
  std::vector<std::uint16_t> own_ports;  ///< ports of the node that other hosts can reach
  std::vector<ListeningPort> all_ports;  ///< all ports of the node's host
};

/// Warnings for the user at the start of a node, one sentence each; none if other hosts can reach nothing.
std::vector<std::string> exposureWarnings(const Exposure& exposure);

/// The host in the address of a ROS master: "robot" in "http://robot:11311/".
std::string hostOfMaster(const std::string& uri);

}  // namespace lamina
