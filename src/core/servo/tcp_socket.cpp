// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/tcp_socket.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

sockaddr_in endpointOf(const std::string& address, std::uint16_t port) {
  sockaddr_in endpoint{};
  endpoint.sin_family = AF_INET;
  endpoint.sin_port = htons(port);
  if (::inet_pton(AF_INET, address.c_str(), &endpoint.sin_addr) != 1)
    throw InvalidConfig("'" + address + "' is no IPv4 address; expected one as 192.168.50.10");
  return endpoint;
}

int newSocket() {
  const int file = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (file < 0) throw DeviceError(std::string("no socket: ") + std::strerror(errno));
  return file;
}

/// A target waits for no other one.
void sendAtOnce(int file) {
  const int on = 1;
  ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

/// Why a connection that has begun was not made; 0 if it was.
int connectionError(int file, double wait_s) {
  pollfd ready{file, POLLOUT, 0};
  if (::poll(&ready, 1, static_cast<int>(std::lround(1e3 * wait_s))) <= 0) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(file, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

}  // namespace

TcpSocket TcpSocket::connectedTo(const std::string& address, std::uint16_t port, double wait_s) {
  const sockaddr_in endpoint = endpointOf(address, port);
  TcpSocket made(newSocket());
  int error = 0;
  if (::connect(made.file_, reinterpret_cast<const sockaddr*>(&endpoint), sizeof endpoint) != 0)
    error = errno == EINPROGRESS ? connectionError(made.file_, wait_s) : errno;
  if (error != 0)
    throw Disconnected("nothing answers at " + address + ":" + std::to_string(port) + ": " +
                       std::strerror(error));
  sendAtOnce(made.file_);
  return made;
}

TcpSocket TcpSocket::listeningOn(const std::string& address, std::uint16_t port) {
  const sockaddr_in endpoint = endpointOf(address, port);
  TcpSocket made(newSocket());
  const int on = 1;
  ::setsockopt(made.file_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (::bind(made.file_, reinterpret_cast<const sockaddr*>(&endpoint), sizeof endpoint) != 0 ||
      ::listen(made.file_, 2) != 0)
    throw DeviceError("cannot listen on " + address + ":" + std::to_string(port) + ": " +
                      std::strerror(errno));
  return made;
}

void TcpSocket::close() {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
}

std::uint16_t TcpSocket::port() const {
  sockaddr_in endpoint{};
  socklen_t size = sizeof endpoint;
  ::getsockname(file_, reinterpret_cast<sockaddr*>(&endpoint), &size);
  return ntohs(endpoint.sin_port);
}

std::string TcpSocket::peer() const {
  sockaddr_in endpoint{};
  socklen_t size = sizeof endpoint;
  std::array<char, INET_ADDRSTRLEN> text{};
  if (::getpeername(file_, reinterpret_cast<sockaddr*>(&endpoint), &size) != 0) return "";
  return ::inet_ntop(AF_INET, &endpoint.sin_addr, text.data(), text.size()) != nullptr ? text.data() : "";
}

TcpSocket TcpSocket::accepted() const {
  const int file = ::accept4(file_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (file >= 0) sendAtOnce(file);
  return TcpSocket(file);
}

bool TcpSocket::send(std::string_view bytes) const {
  return ::send(file_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

std::optional<std::size_t> TcpSocket::read(char* bytes, std::size_t most) const {
  const ssize_t count = ::recv(file_, bytes, most, 0);
  if (count > 0) return static_cast<std::size_t>(count);
  if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return 0;
  return std::nullopt;
}

}  // namespace lamina
