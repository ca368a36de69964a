// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace lamina {

/// Callbacks of a transport; they are called from the thread that runs its io_context.
struct TransportEvents {
  std::function<void(std::string_view bytes)> received;
  /// Called once, when the other end or an error has closed the link.
  std::function<void(const std::string& why)> closed;
};

/// Interface of a link that carries bytes between host and machine.
class Transport {
 public:
  virtual ~Transport() = default;

  /// Opens the link; to be called while the io_context does not run.
  /// @throws Disconnected naming the port if nothing answers there or it cannot be used
  virtual void open(TransportEvents events) = 0;
  /// Queues bytes to be sent; to be called from the thread that runs the io_context.
  virtual void send(const std::string& bytes) = 0;
  /// Whether bytes given to `send` still wait to be sent.
  virtual bool isSending() const = 0;
  virtual void close() = 0;
};

/// Makes the transport for a port: "tcp:host:port", or the path of a serial port or pseudo-terminal.
/// @param baud  rate of a serial port; any that the port supports
/// @throws InvalidInput if `port` has none of these forms
std::unique_ptr<Transport> makeTransport(boost::asio::io_context& context, const std::string& port, int baud);

}  // namespace lamina
