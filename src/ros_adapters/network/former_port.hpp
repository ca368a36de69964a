// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

namespace lamina {

// A node that is started again after it was killed must not get the port of the one before. To roscpp a node
// is its port: who was connected with the killed one would take the new one for it, and never connect with
// it.

/// The port by which the master knows the node of this name; nothing if it knows none, or does not answer. To
/// be called after ros::init. Before the node joins ROS it is the port of the one before.
std::optional<std::uint16_t> formerPort();

/// Keeps a TCP port of this host from being given to whoever asks for any port, as long as it lives. A port
/// that is in use is left as it is.
class HeldPort {
 public:
  explicit HeldPort(std::uint16_t port);
  ~HeldPort();
  HeldPort(const HeldPort&) = delete;
  HeldPort& operator=(const HeldPort&) = delete;

  bool isHeld() const { return descriptor_ >= 0; }

 private:
  int descriptor_ = -1;
};

}  // namespace lamina
