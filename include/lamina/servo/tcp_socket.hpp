// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace lamina {

/// A non-blocking TCP socket (IPv4), which is closed when it is destroyed.
class TcpSocket {
 public:
  TcpSocket() = default;
  ~TcpSocket() { close(); }
  TcpSocket(TcpSocket&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  TcpSocket& operator=(TcpSocket&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }

  /// A socket that is connected to an address; blocks for at most `wait_s`.
  /// @throws InvalidConfig if the address is no IPv4 address; Disconnected with address and reason
  static TcpSocket connectedTo(const std::string& address, std::uint16_t port, double wait_s);
  /// A socket that listens at an address of this host.
  /// @param port  0 for any free one
  /// @throws InvalidConfig if the address is no IPv4 address; DeviceError with address and reason
  static TcpSocket listeningOn(const std::string& address, std::uint16_t port);

  bool isOpen() const { return file_ >= 0; }
  int file() const { return file_; }
  void close();
  /// Port of this end.
  std::uint16_t port() const;
  /// Address of the other end; empty if it is not connected.
  std::string peer() const;
  /// The next connection to this listening socket; a closed socket if there is none.
  TcpSocket accepted() const;
  /// Sends bytes.
  /// @return whether all of them were accepted
  bool send(std::string_view bytes) const;
  /// Reads bytes that have arrived.
  /// @return number of bytes read, 0 if none have arrived; nothing if the connection is closed
  std::optional<std::size_t> read(char* bytes, std::size_t most) const;

 private:
  explicit TcpSocket(int file) : file_(file) {}
  int file_ = -1;
};

}  // namespace lamina
