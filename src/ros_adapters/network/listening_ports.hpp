// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace lamina {

/// A TCP port on which some program of this host waits for connections.
struct ListeningPort {
  std::uint16_t port = 0;
  bool is_on_loopback = false;  ///< bound to 127.0.0.0/8 or ::1: no other host gets through
  std::uint64_t inode = 0;      ///< of its socket, as /proc/self/fd names it
};

/// The listening ones among the sockets in the text of /proc/net/tcp or /proc/net/tcp6. Lines that are not of
/// their form are left out.
std::vector<ListeningPort> listeningPorts(std::string_view table);

}  // namespace lamina
