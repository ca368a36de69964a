// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/serial_port.hpp>

#include "streaming/transport/byte_link.hpp"

namespace lamina {

/// A serial port or pseudo-terminal: 8 data bits, no parity, one stop bit, no flow control, for this process
/// alone.
class SerialTransport final : public Transport {
 public:
  SerialTransport(boost::asio::io_context& context, std::string path, int baud)
      : context_(context), path_(std::move(path)), baud_(baud) {}
  ~SerialTransport() override { close(); }

  void open(TransportEvents events) override;
  void send(const std::string& bytes) override { link_->send(bytes); }
  bool isSending() const override { return link_ && link_->pending() > 0; }
  void close() override;

 private:
  boost::asio::io_context& context_;
  std::string path_;
  int baud_;
  std::shared_ptr<ByteLink<boost::asio::serial_port>> link_;
};

}  // namespace lamina
