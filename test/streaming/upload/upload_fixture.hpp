// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "streaming/upload/simulated_http.hpp"

namespace lamina::test {

inline constexpr const char* kOurFile = "lamina/part-1.gcode";

/// "M104 S200", "M140 S60" and that many moves, none twice.
inline std::string hotProgram(int moves) {
  std::string text = "M104 S200 ; hot\nM140 S60\n";
  for (int i = 0; i < moves; ++i) text += "G1 X" + std::to_string(i) + "\n";
  return text;
}

inline std::shared_ptr<const UploadOrder> orderOf(StreamableProgram program,
                                                  const std::string& credential = "") {
  return std::make_shared<const UploadOrder>(
      UploadOrder{ProgramBody(std::move(program)), kOurFile, credential, 60.0, 10.0});
}
inline std::shared_ptr<const UploadOrder> orderOf(const std::string& text,
                                                  const std::string& credential = "") {
  return orderOf(StreamableProgram::fromText("part", text), credential);
}

using MakeServer = std::unique_ptr<EmulatedPrintServer> (*)();

/// The kinds of print servers, by the name that tests give them.
struct ServerKind {
  const char* name;
  MakeServer make;
  const char* firmware;
};

inline std::vector<std::string> commandsOf(const std::string& text) {
  std::vector<std::string> commands;
  ProgramCursor cursor = StreamableProgram::fromText("part", text).open();
  while (const auto line = cursor.next()) commands.push_back(line->command);
  return commands;
}

}  // namespace lamina::test
