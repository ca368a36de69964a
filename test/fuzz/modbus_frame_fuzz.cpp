// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lamina/modbus/plc_link.hpp"

/// Any bytes, in two pieces, are answered, refused or closed upon.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view stream(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  const std::size_t split = stream.empty() ? 0 : bytes[0] % stream.size();
  lamina::PlcLink link{lamina::PlcLinkSettings{}};
  lamina::FrameReader reader;
  for (const std::string_view piece : {stream.substr(0, split), stream.substr(split)}) {
    reader.add(piece, 0.0);
    while (const auto frame = reader.next()) {
      if (const auto* request = std::get_if<lamina::ModbusRequest>(&*frame)) {
        const std::string answer = link.answer(1, *request, 1.0);
        if (answer.size() < 9 || answer.size() > 260) std::abort();
      }
      if (const auto* refused = std::get_if<lamina::RefusedRequest>(&*frame))
        if (lamina::modbusRefusal(*refused).size() != 9) std::abort();
    }
  }
  return 0;
}
