// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

// The frames of WebSockets (RFC 6455), as a server reads and writes them.

enum class WebSocketOpcode : std::uint8_t {
  Continuation = 0,
  Text = 1,
  Binary = 2,
  Close = 8,
  Ping = 9,
  Pong = 10
};

struct WebSocketFrame {
  WebSocketOpcode opcode = WebSocketOpcode::Text;
  bool is_final = true;
  std::string payload;  ///< unmasked
};

constexpr std::size_t kMostSocketPayload = 4096;  ///< most bytes that a client may send in one frame

/// Reads the frames of a client from the pieces of its byte stream.
class WebSocketReader {
 public:
  void add(std::string_view piece) { held_ += piece; }

  /// The next complete frame; nothing if more bytes are needed.
  /// @throws InvalidInput if the client breaks the rules: no mask, reserved bits or an unknown opcode, a
  ///   payload of more than 4096 bytes, a control frame that is fragmented or longer than 125 bytes
  std::optional<WebSocketFrame> next();

 private:
  std::string held_;
};

/// A frame as a server sends it: unfragmented and without a mask.
std::string webSocketFrame(WebSocketOpcode opcode, std::string_view payload);

/// The value of `Sec-WebSocket-Accept` that answers a client's key.
std::string webSocketAccept(const std::string& key);

}  // namespace lamina
