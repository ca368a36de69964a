// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/ip/tcp.hpp>

#include "streaming/transport/byte_link.hpp"

namespace lamina {

/// A machine that listens on TCP.
class TcpTransport final : public Transport {
 public:
  TcpTransport(boost::asio::io_context& context, std::string host, std::string port)
      : context_(context), host_(std::move(host)), port_(std::move(port)) {}
  ~TcpTransport() override { close(); }

  void open(TransportEvents events) override;
  void send(const std::string& bytes) override { link_->send(bytes); }
  bool isSending() const override { return link_ && link_->pending() > 0; }
  void close() override;

 private:
  boost::asio::io_context& context_;
  std::string host_;
  std::string port_;
  std::shared_ptr<ByteLink<boost::asio::ip::tcp::socket>> link_;
};

}  // namespace lamina
