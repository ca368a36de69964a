// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/ok_paced/paced_lines.hpp"

#include <utility>

namespace lamina {
namespace {

constexpr const char* kEndOfMotions = "M400";

}  // namespace

PacedLines::PacedLines(const StreamableProgram& program, std::shared_ptr<RevisedLines> revised)
    : revised_(std::move(revised)), program_(sourceOf(program, revised_)), total_(program.lines()) {}

bool PacedLines::isNextKnown() { return !revised_ || !is_rest_given_ || revised_->isNextKnown(); }

std::optional<ProgramLine> PacedLines::next() {
  if (revised_ && !revised_->isNextKnown()) {
    is_rest_given_ = true;
    ++rests_;
    ++given_;
    return ProgramLine{kEndOfMotions, layer_};
  }
  auto line = program_();
  count();
  if (line) {
    is_rest_given_ = false;
    layer_ = line->layer;
    ++given_;
    return line;
  }
  if (given_ != total_) return std::nullopt;
  ++given_;
  return ProgramLine{kEndOfMotions, -1};
}

void PacedLines::count() {
  if (revised_) total_ = revised_->total() + rests_;
}

}  // namespace lamina
