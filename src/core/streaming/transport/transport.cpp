// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/transport/transport.hpp"

#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/serial_port.hpp>
#include <cerrno>
#include <chrono>
#include <system_error>

#include "lamina/base/error.hpp"
#include "streaming/transport/byte_link.hpp"
#include "streaming/transport/serial_baud.hpp"

namespace lamina {
namespace {

/// The reason, and what to do about it.
Disconnected notOpened(const std::string& path, const std::string& reason, int error_number) {
  const char* advice = "; is the machine connected?";
  if (error_number == EBUSY) advice = "; another program has it open";
  if (error_number == EACCES) advice = "; expected a user who may open it, as one of the group dialout";
  return Disconnected("cannot open port " + path + ": " + reason + advice);
}

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

using boost::asio::ip::tcp;

constexpr std::chrono::seconds kConnectTimeout{5};

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

using boost::asio::serial_port;

/// A port belongs to one process, even if root opens it again, whom TIOCEXCL does not hold back.
void claim(serial_port& port) {
  if (::flock(port.native_handle(), LOCK_EX | LOCK_NB) == 0) return;
  throw std::system_error(EBUSY, std::generic_category());
}

/// Where closing lowers DTR, the next opening raises it, which resets many boards: a job could not go on.
void keepLinesAtClose(int descriptor) {
  termios options{};
  if (::tcgetattr(descriptor, &options) != 0) return;
  options.c_cflag &= ~static_cast<tcflag_t>(HUPCL);
  ::tcsetattr(descriptor, TCSANOW, &options);
}

void configure(serial_port& port, int baud) {
  port.set_option(serial_port::character_size(8));
  port.set_option(serial_port::parity(serial_port::parity::none));
  port.set_option(serial_port::stop_bits(serial_port::stop_bits::one));
  port.set_option(serial_port::flow_control(serial_port::flow_control::none));
  setBaudRate(port.native_handle(), baud);
  keepLinesAtClose(port.native_handle());
  ::ioctl(port.native_handle(), TIOCEXCL);
  // What was said before nobody listened to is of no use.
  ::tcflush(port.native_handle(), TCIFLUSH);
}

void SerialTransport::open(TransportEvents events) {
  try {
    serial_port port(context_, path_);
    claim(port);
    configure(port, baud_);
    link_ = std::make_shared<ByteLink<serial_port>>(std::move(port));
  } catch (const std::system_error& error) {
    throw notOpened(path_, error.code().message(), error.code().value());
  } catch (const boost::system::system_error& error) {
    throw notOpened(path_, error.code().message(), error.code().value());
  }
  link_->start(std::move(events));
}

void SerialTransport::close() {
  if (link_) link_->close();
}

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
