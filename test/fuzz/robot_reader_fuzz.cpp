// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/program/robot/robot_reader.hpp"

/// Any bytes are read into a valid toolpath or refused as InvalidProgram, in each language.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  for (const lamina::RobotLanguage language : lamina::kRobotLanguages) try {
      const std::string name = std::string("fuzz") + lamina::suffixOf(language);
      lamina::validate(lamina::readRobotProgram({{name, text}}, "fuzz"));
    } catch (const lamina::InvalidProgram&) {
    } catch (const lamina::InvalidInput&) {
      std::abort();  // `validate` refuses what the reader made
    }
  return 0;
}
