// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/web_socket.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina::test {
namespace {

std::string bytesOf(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

TEST(WebSocket, AnswersTheKeyOfTheStandard) {
  EXPECT_EQ(webSocketAccept("dGhlIHNhbXBsZSBub25jZQ=="),
            "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");  // RFC 6455, section 1.3
}

TEST(WebSocket, ReadsMaskedFramesHoweverTheyAreSplit) {
  // RFC 6455, section 5.7: "Hello" with a mask; then a ping without payload.
  const std::string stream = bytesOf({0x81, 0x85, 0x37, 0xfa, 0x21, 0x3d, 0x7f, 0x9f, 0x4d, 0x51, 0x58}) +
                             bytesOf({0x89, 0x80, 1, 2, 3, 4});
  WebSocketReader reader;
  std::vector<WebSocketFrame> frames;
  for (const char byte : stream) {
    reader.add({&byte, 1});
    while (const auto frame = reader.next()) frames.push_back(*frame);
  }
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].payload, "Hello");
  EXPECT_EQ(frames[0].opcode, WebSocketOpcode::Text);
  EXPECT_EQ(frames[1].opcode, WebSocketOpcode::Ping);
}

TEST(WebSocket, RefusesWhatAClientMayNotSend) {
  for (const auto& frame :
       {bytesOf({0x81, 0x05}), bytesOf({0xc1, 0x80}), bytesOf({0x83, 0x80}), bytesOf({0x81, 0xff}),
        bytesOf({0x81, 0xfe, 0x10, 0x01}), bytesOf({0x09, 0x80}), bytesOf({0x89, 0xfe, 0, 126})}) {
    WebSocketReader reader;
    reader.add(frame);
    EXPECT_THROW(reader.next(), InvalidInput) << ::testing::PrintToString(frame);
  }
}

TEST(WebSocket, WritesLengthsInThreeForms) {
  EXPECT_EQ(webSocketFrame(WebSocketOpcode::Text, "ab"), bytesOf({0x81, 2, 'a', 'b'}));
  EXPECT_EQ(webSocketFrame(WebSocketOpcode::Text, std::string(300, 'x')).substr(0, 5),
            bytesOf({0x81, 126, 1, 44, 'x'}));
  EXPECT_EQ(webSocketFrame(WebSocketOpcode::Text, std::string(70000, 'x')).substr(0, 10),
            bytesOf({0x81, 127, 0, 0, 0, 0, 0, 1, 0x11, 0x70}));
}

}  // namespace
}  // namespace lamina::test
