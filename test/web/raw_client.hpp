// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

namespace lamina::test {

/// A client that sends bytes as they are given, and waits a minute for the answer at most.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port, const char* from = "127.0.0.1")
      : descriptor_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in own = addressOf(from, 0);
    const bool is_bound = ::bind(descriptor_, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0;
    sockaddr_in other = addressOf("127.0.0.1", port);
    is_connected_ =
        is_bound && ::connect(descriptor_, reinterpret_cast<const sockaddr*>(&other), sizeof other) == 0;
  }
  RawClient(RawClient&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)), is_connected_(other.is_connected_) {}
  RawClient& operator=(RawClient&&) = delete;
  ~RawClient() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  int descriptor() const { return descriptor_; }
  bool isConnected() const { return is_connected_; }

  /// @return false if the other end is gone
  bool send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

  /// What comes until a text has come, or the other end closes.
  std::string until(std::string_view wanted) const {
    std::string text;
    while (wanted.empty() || text.find(wanted) == std::string::npos)
      if (!more(text)) break;
    return text;
  }
  std::string rest() const { return until(""); }

  /// One answer with Content-Length.
  std::string answer() const {
    std::string text = until("\r\n\r\n");
    const std::size_t head = text.find("\r\n\r\n");
    const std::size_t length = text.find("Content-Length: ");
    if (head == std::string::npos || length == std::string::npos || length > head) return text;
    const std::size_t size = head + 4 + std::strtoul(text.c_str() + length + 16, nullptr, 10);
    while (text.size() < size && more(text)) {
    }
    return text;
  }

 private:
  static sockaddr_in addressOf(const char* host, std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    ::inet_pton(AF_INET, host, &address.sin_addr);
    return address;
  }
  bool more(std::string& text) const {
    pollfd poll{descriptor_, POLLIN, 0};
    if (::poll(&poll, 1, 60000) <= 0) return false;
    std::array<char, 16384> bytes{};
    const ssize_t count = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
    if (count <= 0) return false;
    text.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }

  int descriptor_;
  bool is_connected_ = false;
};

}  // namespace lamina::test
