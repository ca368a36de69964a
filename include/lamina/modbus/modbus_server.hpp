// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lamina/modbus/modbus_frame.hpp"

namespace lamina {

/// Where the server listens, and which clients it serves.
struct ModbusServerSettings {
  std::string bind = "127.0.0.1";  ///< address to listen on
  std::uint16_t port = 1502;       ///< 0 for any that is free
  std::size_t connections = 4;     ///< most at a time; further ones are closed at once
  /// Silence after which a connection may be closed for a new one from the same address, if all are in use.
  double replaceable_after_s = 10.0;
  std::vector<std::string> allow = {"127.0.0.1"};  ///< addresses from which clients may connect
  double half_frame_s = 1.0;                       ///< time within which a frame must be complete
};

/// Functions that the server calls, all from its own thread, one after the other.
struct ModbusPeers {
  /// Returns the answer to a request, as bytes.
  std::function<std::string(int connection, const ModbusRequest& request)> answer;
  /// Called when a connection was closed.
  std::function<void(int connection)> closed;
  /// Called when a connection was closed because a frame was broken, or not complete in time.
  std::function<void(const std::string& address, const std::string& reason)> broken;
};

/// Listens for Modbus TCP clients in a thread of its own. A connection is read again only once its last
/// answers have been written, so that slow readers take no memory.
class ModbusServer {
 public:
  /// @throws DeviceError if it cannot listen there, with address and reason
  ModbusServer(ModbusServerSettings settings, ModbusPeers peers);
  /// Closes all connections.
  ~ModbusServer();
  ModbusServer(const ModbusServer&) = delete;
  ModbusServer& operator=(const ModbusServer&) = delete;

  /// The TCP port on which it listens.
  std::uint16_t port() const;

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace lamina
