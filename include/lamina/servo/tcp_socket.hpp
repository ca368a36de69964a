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

/// An IPv4 socket of TCP that never waits unless asked to; closed at its end.
class TcpSocket {
 public:
  TcpSocket() = default;
  ~TcpSocket() { close(); }
  TcpSocket(TcpSocket&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  TcpSocket& operator=(TcpSocket&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }

  /// Waits at most so long.
  /// @throws InvalidConfig if the address is no IPv4 address; Disconnected with address and reason
  static TcpSocket connectedTo(const std::string& address, std::uint16_t port, double wait_s);
  /// @param port  0 for any that is free
  /// @throws InvalidConfig if the address is no IPv4 address; DeviceError with address and reason
  static TcpSocket listeningOn(const std::string& address, std::uint16_t port);

  bool isOpen() const { return file_ >= 0; }
  int file() const { return file_; }
  void close();
  /// Of its own end.
  std::uint16_t port() const;
  /// Address of the other end; empty if there is none.
  std::string peer() const;
  /// The next that connects to it; closed if none has.
  TcpSocket accepted() const;
  /// Whether all of it was taken.
  bool send(std::string_view bytes) const;
  /// What has come.
  /// @return bytes read; 0 if nothing has come; nothing if the other end has closed
  std::optional<std::size_t> read(char* bytes, std::size_t most) const;

 private:
  explicit TcpSocket(int file) : file_(file) {}
  int file_ = -1;
};

}  // namespace lamina
