// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "lamina/base/error.hpp"
#include "streaming/upload/upload_job.hpp"

namespace {

/// A response whose status is that of the first byte, and whose body is what follows.
lamina::HttpResponse responseFrom(std::string_view text, const lamina::ProgramBody& body) {
  constexpr std::array<int, 8> kStatus = {200, 200, 201, 204, 401, 404, 500, 503};
  lamina::HttpResponse response;
  const auto first = text.empty() ? 0U : static_cast<unsigned char>(text[0]);
  response.status = kStatus[first % kStatus.size()];
  response.body = text.substr(std::min<std::size_t>(1, text.size()));
  response.digested_bytes = (first & 0x80U) != 0 ? 0 : body.bytes();
  response.digested_crc32 = (first & 0x40U) != 0 ? 0 : body.crc32();
  return response;
}

}  // namespace

/// Any bytes are a print server's answers: the first chooses who is expected, a zero ends an answer.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array<const char*, 3> kFirmware = {"auto", "klipper", "reprapfirmware"};
  lamina::StreamSettings settings;
  settings.firmware = kFirmware[bytes[0] % kFirmware.size()];
  static const auto order = std::make_shared<const lamina::UploadOrder>(lamina::UploadOrder{
      lamina::ProgramBody(lamina::StreamableProgram::fromText("part", "M104 S200\nG1 X1\nG1 X2\n")),
      "lamina/part-1.gcode", "", 60.0, 10.0});
  lamina::UploadJob job(settings, order);
  double now = 0.0;
  job.start(now);
  std::string_view rest(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  // Once nothing more is said, a server that is not reached ends every job.
  for (int i = 0; i < 20000 && !isFinal(job.status().state); ++i) {
    job.takeBreak();
    if (job.takeRequest(now)) {
      const std::size_t piece = rest.find('\0');
      if (rest.empty()) {
        job.fail({"connection refused", false}, now);
      } else {
        job.receive(responseFrom(rest.substr(0, piece), order->body), now);
        rest.remove_prefix(piece == std::string_view::npos ? rest.size() : piece + 1);
      }
    } else {
      now = std::clamp(job.nextDeadline(), now, now + 60.0);
      job.elapse(now);
    }
  }
  if (!isFinal(job.status().state)) std::abort();
  if (job.status().lines_acknowledged > job.status().lines_total) std::abort();
  return 0;
}
