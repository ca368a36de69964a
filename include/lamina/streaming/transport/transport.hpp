// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace lamina {

/// Callbacks of a transport, from the thread that runs its io_context.
struct TransportEvents {
  std::function<void(std::string_view bytes)> received;
  std::function<void(const std::string& why)> closed;  ///< by the other end or by an error; at most once
};

/// The link for bytes between host and machine.
class Transport {
 public:
  virtual ~Transport() = default;

  /// Opens the link. To be called before the io_context runs.
  /// @throws Disconnected naming the port if nothing answers there or it cannot be used
  virtual void open(TransportEvents events) = 0;
  /// Queues bytes to be sent; from the thread that runs the io_context.
  virtual void send(const std::string& bytes) = 0;
  /// True while bytes given to `send` have not left.
  virtual bool isSending() const = 0;
  virtual void close() = 0;
};

/// A transport by its name: "tcp:host:port", or the path of a serial port or pseudo-terminal.
/// @param baud  of a serial port; any rate the port can do
/// @throws InvalidInput if the name is no port
std::unique_ptr<Transport> makeTransport(boost::asio::io_context& context, const std::string& port, int baud);

}  // namespace lamina
