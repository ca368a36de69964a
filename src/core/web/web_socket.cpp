// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/web_socket.hpp"

#include <openssl/sha.h>

#include <array>

#include "lamina/base/base64.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::uint8_t kFinal = 0x80;
constexpr std::uint8_t kReserved = 0x70;
constexpr std::uint8_t kMasked = 0x80;
constexpr std::size_t kMaskBytes = 4;
constexpr std::size_t kShort = 125;  // longest payload whose length is one byte

bool isControlFrame(std::uint8_t opcode) { return (opcode & 8) != 0; }

bool isOpcode(std::uint8_t opcode) { return opcode <= 2 || (opcode >= 8 && opcode <= 10); }

void requireFrame(std::uint8_t first, std::uint8_t second) {
  const std::uint8_t opcode = first & 0x0f;
  if ((first & kReserved) != 0) throw InvalidInput("a WebSocket frame has reserved bits set");
  if (!isOpcode(opcode)) throw InvalidInput("a WebSocket frame has opcode " + std::to_string(opcode));
  if ((second & kMasked) == 0) throw InvalidInput("a WebSocket frame of a client has no mask");
  const bool is_long = (second & 0x7f) > kShort;
  if (isControlFrame(opcode) && (is_long || (first & kFinal) == 0))
    throw InvalidInput("a WebSocket control frame is longer than 125 bytes, or in pieces");
}

}  // namespace

std::optional<WebSocketFrame> WebSocketReader::next() {
  const auto byte = [this](std::size_t at) { return static_cast<std::uint8_t>(held_.at(at)); };
  if (held_.size() < 2) return std::nullopt;
  requireFrame(byte(0), byte(1));
  std::size_t length = byte(1) & 0x7f;
  std::size_t head = 2;
  if (length == 127) throw InvalidInput("a WebSocket frame is longer than 4096 bytes");
  if (length == 126) {
    if (held_.size() < 4) return std::nullopt;
    length = static_cast<std::size_t>(byte(2)) << 8 | byte(3);
    head = 4;
  }
  if (length > kMostSocketPayload)
    throw InvalidInput("a WebSocket frame has " + std::to_string(length) + " bytes; expected at most 4096");
  if (held_.size() < head + kMaskBytes + length) return std::nullopt;
  WebSocketFrame frame;
  frame.opcode = static_cast<WebSocketOpcode>(byte(0) & 0x0f);
  frame.is_final = (byte(0) & kFinal) != 0;
  for (std::size_t i = 0; i < length; ++i)
    frame.payload += static_cast<char>(byte(head + kMaskBytes + i) ^ byte(head + i % kMaskBytes));
  held_.erase(0, head + kMaskBytes + length);
  return frame;
}

std::string webSocketFrame(WebSocketOpcode opcode, std::string_view payload) {
  std::string frame(1, static_cast<char>(kFinal | static_cast<std::uint8_t>(opcode)));
  if (payload.size() <= kShort) {
    frame += static_cast<char>(payload.size());
  } else {
    const int bytes = payload.size() <= 0xffff ? 2 : 8;
    frame += static_cast<char>(bytes == 2 ? 126 : 127);
    for (int i = bytes - 1; i >= 0; --i)
      frame += static_cast<char>(static_cast<std::uint64_t>(payload.size()) >> (8 * i) & 0xff);
  }
  return frame.append(payload);
}

std::string webSocketAccept(const std::string& key) {
  const std::string text = key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
  std::array<unsigned char, SHA_DIGEST_LENGTH> digest{};
  SHA1(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  return base64({reinterpret_cast<const char*>(digest.data()), digest.size()});
}

}  // namespace lamina
