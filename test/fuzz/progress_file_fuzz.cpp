// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/streaming/journal/job_progress.hpp"

/// Any bytes are read as a job's progress, or refused as damaged.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    lamina::decodeJournal({reinterpret_cast<const char*>(bytes), size}, "fuzz");
  } catch (const lamina::FileError&) {
  }
  return 0;
}
