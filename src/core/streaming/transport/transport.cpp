// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/transport/transport.hpp"

#include "lamina/base/error.hpp"
#include "streaming/transport/serial_transport.hpp"
#include "streaming/transport/tcp_transport.hpp"

namespace lamina {
namespace {

constexpr std::string_view kTcp = "tcp:";

std::unique_ptr<Transport> makeTcp(boost::asio::io_context& context, const std::string& port) {
  const std::string address = port.substr(kTcp.size());
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == address.size()) {
    throw InvalidInput("port is \"" + port + "\"; expected tcp:host:port");
  }
  return std::make_unique<TcpTransport>(context, address.substr(0, colon), address.substr(colon + 1));
}

}  // namespace

std::unique_ptr<Transport> makeTransport(boost::asio::io_context& context, const std::string& port,
                                         int baud) {
  if (port.empty()) throw InvalidInput("no port given; expected tcp:host:port or the path of a serial port");
  if (port.compare(0, kTcp.size(), kTcp) == 0) return makeTcp(context, port);
  return std::make_unique<SerialTransport>(context, port, baud);
}

}  // namespace lamina
