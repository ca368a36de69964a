// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What the page reads of the network by itself: addresses, cookies, forms, frames of WebSockets.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/web/http_message.hpp"
#include "lamina/web/multipart_reader.hpp"
#include "lamina/web/web_socket.hpp"

namespace {

void require(bool is_so) {
  if (!is_so) std::abort();
}

void readForm(std::string_view bytes, std::size_t step) {
  int open = 0;
  lamina::MultipartReader reader(
      "b", {[&](const lamina::MultipartHead& head) {
              require(open++ == 0 && !head.name.empty());
              if (head.filename) {
                const std::string name = lamina::safeFileName(*head.filename);
                require(!name.empty() && name.size() <= 120 && name != ".." &&
                        name.find('/') == std::string::npos);
              }
            },
            [&](std::string_view) { require(open == 1); }, [&] { require(open-- == 1); }});
  try {
    for (; !bytes.empty(); bytes.remove_prefix(std::min(step, bytes.size())))
      reader.read(bytes.substr(0, step));
    reader.finish();
  } catch (const lamina::InvalidInput&) {
  }
}

void readFrames(std::string_view bytes) {
  lamina::WebSocketReader reader;
  reader.add(bytes);
  try {
    while (const auto frame = reader.next()) require(frame->payload.size() <= lamina::kMostSocketPayload);
  } catch (const lamina::InvalidInput&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (const auto target = lamina::parsedTarget(bytes))
    for (const std::string& segment : target->segments)
      require(segment != ".." && segment.find('/') == std::string::npos);
  lamina::cookieValue(bytes, "lamina_session");
  lamina::hostName(bytes);
  lamina::multipartBoundary(bytes);
  readForm(bytes, 1 + data[0]);
  readFrames(bytes);
  return 0;
}
