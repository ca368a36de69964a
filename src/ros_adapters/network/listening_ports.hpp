// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace lamina {

/// A TCP port on which a program of this host waits for connections.
struct ListeningPort {
  std::uint16_t port = 0;
  /// Whether it is bound to 127.0.0.0/8 or ::1: no other host can reach it.
  bool is_on_loopback = false;
  std::uint64_t inode = 0;  ///< inode of its socket, as in /proc/self/fd
};

/// The listening sockets in the text of /proc/net/tcp or /proc/net/tcp6. Lines of any other form are skipped.
std::vector<ListeningPort> listeningPorts(std::string_view table);

}  // namespace lamina
