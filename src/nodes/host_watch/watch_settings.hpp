// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/cell/host_watch.hpp"
#include "lamina/streaming/guard/machine_guard.hpp"

namespace lamina {

/// Parameters of the node host_watch.
struct HostWatchNodeSettings {
  HostWatchSettings watch;
  std::string bind = "127.0.0.1";
  int port = 11412;
  SettingTable peers;
  std::string needed;
  double interval_s = 0.1;
  double shift_s = 0.0;
  std::string folder = ".";
  double least_gib = 2.0;
  std::string nodes;
  std::string guard_socket;  ///< of the streamer whose machine is watched; empty for none
  GuardSettings guard;
};

/// Another host, and its address.
struct PeerAddress {
  PeerHost host;
  std::string address;  ///< IPv4, in figures
  int port = 0;
};

/// Adds the keys hosts.*, clock.*, master.*, disk.*, nodes and guard.*.
void describe(SettingsSchema& schema, HostWatchNodeSettings& settings);

/// The settings of the watch in the core.
HostWatchSettings watchOf(const HostWatchNodeSettings& settings);

/// The other hosts, in the order of their names.
/// @throws InvalidConfig for an invalid address, and for a required host that is not stated
std::vector<PeerAddress> peersOf(const HostWatchNodeSettings& settings);

/// Full names of the nodes that are watched.
/// @param space  namespace of the watch, in which names without a leading slash are
/// @throws InvalidConfig for a name that no node can have
std::vector<std::string> watchedNodes(const HostWatchNodeSettings& settings, const std::string& space);

}  // namespace lamina
