// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/transport/serial_transport.hpp"

#include <sys/ioctl.h>
#include <termios.h>

#include "lamina/base/error.hpp"
#include "streaming/transport/serial_baud.hpp"

namespace lamina {
namespace {

using boost::asio::serial_port;

void configure(serial_port& port, int baud) {
  port.set_option(serial_port::character_size(8));
  port.set_option(serial_port::parity(serial_port::parity::none));
  port.set_option(serial_port::stop_bits(serial_port::stop_bits::one));
  port.set_option(serial_port::flow_control(serial_port::flow_control::none));
  setBaudRate(port.native_handle(), baud);
  ::ioctl(port.native_handle(), TIOCEXCL);
  // What was said before nobody listened to is of no use.
  ::tcflush(port.native_handle(), TCIFLUSH);
}

}  // namespace

void SerialTransport::open(TransportEvents events) {
  try {
    serial_port port(context_, path_);
    configure(port, baud_);
    link_ = std::make_shared<ByteLink<serial_port>>(std::move(port));
  } catch (const std::system_error& error) {
    throw Disconnected("cannot open port " + path_ + ": " + error.code().message() +
                       "; is the machine connected?");
  } catch (const boost::system::system_error& error) {
    throw Disconnected("cannot open port " + path_ + ": " + error.code().message() +
                       "; is the machine connected?");
  }
  link_->start(std::move(events));
}

void SerialTransport::close() {
  if (link_) link_->close();
}

}  // namespace lamina
