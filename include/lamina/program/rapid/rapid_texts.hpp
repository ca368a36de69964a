// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "lamina/program/rapid/reader/rapid_reader.hpp"
#include "lamina/program/rapid/writer/rapid_writer.hpp"

namespace lamina {

/// A program in RAPID as its files would hold it, to be read before any of them is written.
class RapidTexts {
 public:
  explicit RapidTexts(const RapidProgram& program);
  RapidTexts(const RapidTexts&) = delete;
  RapidTexts& operator=(const RapidTexts&) = delete;

  /// Main first; they refer to this object.
  const std::vector<RapidText>& modules() const { return modules_; }

 private:
  std::deque<std::string> texts_;
  std::vector<RapidText> modules_;
};

}  // namespace lamina
