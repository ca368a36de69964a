// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

namespace lamina {

// A node that is restarted after it was killed must not get the port of its predecessor. roscpp identifies a
// node by its port: nodes that were connected to the predecessor would mistake the new node for it, and never
// connect.

/// The port by which the master knows the node of this name; nothing if it knows none, or does not answer. To
/// be called after ros::init. Before the node joins ROS it is the predecessor's port.
std::optional<std::uint16_t> formerPort();

/// Reserves a TCP port of this host during the object's lifetime: the system does not assign it to programs
/// that request any port. A port in use is left unchanged.
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
