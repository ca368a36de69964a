// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/transport/tcp_transport.hpp"

#include <boost/asio/connect.hpp>
#include <chrono>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using boost::asio::ip::tcp;

constexpr std::chrono::seconds kConnectTimeout{5};

}  // namespace

void TcpTransport::open(TransportEvents events) {
  boost::system::error_code error;
  const auto endpoints = tcp::resolver(context_).resolve(host_, port_, error);
  tcp::socket socket(context_);
  if (!error) {
    error = boost::asio::error::timed_out;
    boost::asio::async_connect(
        socket, endpoints,
        [&](const boost::system::error_code& result, const tcp::endpoint&) { error = result; });
    context_.restart();
    context_.run_for(kConnectTimeout);
    if (!context_.stopped()) {
      socket.close();
      context_.run();
      error = boost::asio::error::timed_out;
    }
    context_.restart();
  }
  if (error) {
    throw Disconnected("cannot connect to tcp:" + host_ + ":" + port_ + ": " + error.message() +
                       "; is the machine on?");
  }
  socket.set_option(tcp::no_delay(true));
  socket.set_option(boost::asio::socket_base::keep_alive(true));
  link_ = std::make_shared<ByteLink<tcp::socket>>(std::move(socket));
  link_->start(std::move(events));
}

void TcpTransport::close() {
  if (link_) link_->close();
}

}  // namespace lamina
