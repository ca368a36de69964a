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

struct ModbusServerSettings {
  std::string bind = "127.0.0.1";  ///< address to listen on
  std::uint16_t port = 1502;       ///< 0 for any that is free
  std::size_t connections = 4;     ///< at once; more are closed as they come
  double give_way_s = 10.0;        ///< of silence after which one makes place for its own address
  std::vector<std::string> allow = {"127.0.0.1"};  ///< addresses that may connect
  double half_frame_s = 1.0;                       ///< that a frame may take to come whole
};

/// What the server asks and reports. All calls come from its own thread, one after the other.
struct ModbusPeers {
  /// The answer to a request, as bytes.
  std::function<std::string(int connection, const ModbusRequest& request)> answer;
  /// A connection is gone.
  std::function<void(int connection)> closed;
  /// A frame was broken, or did not come whole in time; its connection is closed.
  std::function<void(const std::string& address, const std::string& reason)> broken;
};

/// Listens for Modbus TCP clients in a thread of its own. A connection is read again only when its last
/// answers have been written, so that slow readers cost no memory.
class ModbusServer {
 public:
  /// @throws DeviceError if it cannot listen there, with address and reason
  ModbusServer(ModbusServerSettings settings, ModbusPeers peers);
  /// Closes all connections.
  ~ModbusServer();
  ModbusServer(const ModbusServer&) = delete;
  ModbusServer& operator=(const ModbusServer&) = delete;

  /// The port it listens on.
  std::uint16_t port() const;

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace lamina
