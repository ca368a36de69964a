// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/rapid/rapid_texts.hpp"

#include <string_view>

namespace lamina {

RapidTexts::RapidTexts(const RapidProgram& program) {
  const std::vector<std::string>& names = program.moduleNames();
  modules_.reserve(names.size());
  for (std::size_t m = 0; m < names.size(); ++m) {
    std::string& text = texts_.emplace_back();
    program.write(m, [&text](std::string_view piece) { text.append(piece); });
    modules_.push_back({names[m] + ".mod", text});
  }
}

}  // namespace lamina
