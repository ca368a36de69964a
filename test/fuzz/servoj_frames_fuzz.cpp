// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "lamina/servo/emulated_robot.hpp"
#include "lamina/servo/servoj_frames.hpp"

/// Any bytes, in two pieces, are reports of joints that can be or break the reader off; so are frames of
/// targets, and programs.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view stream(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  const std::size_t split = stream.empty() ? 0 : bytes[0] % stream.size();
  lamina::ReportReader reader;
  lamina::FrameCutter<lamina::TargetBytes> cutter;
  for (const std::string_view piece : {stream.substr(0, split), stream.substr(split)}) {
    reader.add(piece);
    if (reader.last() && !(reader.last()->position.cwiseAbs().maxCoeff() <= 20.0)) std::abort();
    cutter.add(piece, [](const lamina::TargetBytes& frame) {
      const lamina::TargetFrame read = lamina::targetOf(frame);
      const bool is_target = read.kind == lamina::TargetFrame::Kind::Target;
      if (is_target && !(read.target.ahead.velocity.cwiseAbs().maxCoeff() <= 20.0)) std::abort();
      return true;
    });
  }
  lamina::sentProgram(std::string(stream.substr(0, 4096)));
  return 0;
}
