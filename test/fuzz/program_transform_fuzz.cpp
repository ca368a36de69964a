// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/gcode_rewrite/gcode_rewrite.hpp"
#include "support/scratch_folder.hpp"

namespace {

lamina::RewriteSettings settingsFrom(std::uint8_t choices) {
  lamina::RewriteSettings settings;
  settings.layer_height_mm = 0.3;
  settings.offset_mm.z() = 1e6;  // over the bed, whatever there is
  if ((choices & 1U) != 0) settings.mode = lamina::RewriteMode::Listing;
  if ((choices & 2U) != 0) settings.build_aids = lamina::BuildAids::Dropped;
  if ((choices & 4U) != 0) settings.homing = lamina::Homing::Kept;
  return settings;
}

}  // namespace

/// Any bytes are transformed, or refused with nothing written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  static const lamina::test::ScratchFolder folder;
  const std::string files[] = {folder.file("in.gcode"), folder.file("out.gcode")};
  lamina::writeFile(files[0], {reinterpret_cast<const char*>(bytes) + 1, size - 1});
  const lamina::AffineMap turn = lamina::rotation({1.0, 0.0, 0.0}, 45.0);
  const lamina::AffineMap stretch = lamina::scaling({1.0, 2.0, 3.0});
  const bool stretches = (bytes[0] & 9U) == 8U;
  const lamina::SpaceMap& map = stretches ? static_cast<const lamina::SpaceMap&>(stretch) : turn;
  lamina::NoProgress progress;
  ::unlink(files[1].c_str());
  try {
    const lamina::RewriteSettings settings = settingsFrom(bytes[0]);
    rewriteProgram({files[0], files[1]}, {map}, settings, progress);
  } catch (const lamina::InvalidInput&) {
    if (::access(files[1].c_str(), F_OK) == 0) std::abort();
  } catch (const lamina::Unreachable&) {
    if (::access(files[1].c_str(), F_OK) == 0) std::abort();
  }
  for (const std::string& file : files) ::unlink(file.c_str());
  return 0;
}
