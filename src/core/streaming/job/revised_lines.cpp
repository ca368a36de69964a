// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/revised_lines.hpp"

#include <utility>

#include "lamina/streaming/job/firmware_protocol.hpp"

namespace lamina {
namespace {

/// The lines of its text, each as it is.
LineFeed::Source rawLinesOf(const StreamableProgram& program) {
  const std::shared_ptr<std::istream> text = program.openText();
  LineFeed::Source source = [text]() -> std::optional<ProgramLine> {
    ProgramLine line;
    if (!std::getline(*text, line.command)) return std::nullopt;
    return line;
  };
  if (program.isHeld()) return source;
  return readAhead(
      source, [program] { return program.hasChanged(); }, kLongestRead);
}

}  // namespace

GrowingCommands::GrowingCommands()
    : text_(new std::stringstream), cursor_(std::unique_ptr<std::istream>(text_)) {}

void GrowingCommands::give(std::string_view lines) {
  text_->clear();
  text_->str(std::string(lines));
}

std::optional<ProgramLine> GrowingCommands::next() { return cursor_.next(); }

RevisedLines::RevisedLines(const StreamableProgram& program, std::shared_ptr<ProgramRevision> revision,
                           std::function<std::string(const std::string&)> defectOf)
    : program_(program),
      revision_(std::move(revision)),
      defectOf_(std::move(defectOf)),
      text_(rawLinesOf(program)) {}

bool RevisedLines::isNextKnown() {
  readOn();
  return line_ || is_over_;
}

std::optional<ProgramLine> RevisedLines::next() {
  readOn();
  return std::exchange(line_, std::nullopt);
}

void RevisedLines::decide() {
  if (awaited_) revision_->decide(*awaited_);
}

void RevisedLines::end(const Failure& why) {
  is_over_ = true;
  failure_ = why;
}

void RevisedLines::readOn() {
  while (!line_ && !is_over_) {
    if (awaited_ && !revision_->isKnown(*awaited_)) {
      const std::optional<StreamableProgram> successor = revision_->successor(*awaited_);
      if (!successor) return;
      goOnWith(*successor);
    }
    awaited_.reset();
    line_ = revised_.next();
    if (line_) {
      ++given_;
      line_->seconds = time_.secondsOf(line_->command);
      const std::string defect = defectOf_(line_->command);
      if (!defect.empty())
        end({ErrorCode::InvalidProgram, "line " + std::to_string(number_) + " became one that " + defect});
    } else if (revised_.layer() != layer_) {
      layer_ = revised_.layer();
      awaited_ = layer_;
    } else {
      readLine();
    }
  }
  if (is_over_ && failure_.code != ErrorCode::Ok) line_.reset();
}

void RevisedLines::goOnWith(const StreamableProgram& successor) {
  program_ = successor;
  text_ = rawLinesOf(program_);
  number_ = 0;
  read_ = 0;
}

void RevisedLines::readLine() {
  const std::optional<ProgramLine> raw = text_();
  if (!raw) return end({});  // the count shows whether lines are missing
  planned_.give(raw->command);
  while (planned_.next()) ++read_;
  try {
    revised_.give(revision_->revised(raw->command, ++number_));
  } catch (const Error&) {
    end(currentFailure());
  }
}

std::shared_ptr<RevisedLines> revisedLines(const StreamOrder& order,
                                           const std::shared_ptr<const FirmwareProtocol>& firmware) {
  if (!order.revision) return nullptr;
  return std::make_shared<RevisedLines>(order.program, order.revision,
                                        [firmware, settings = order.settings](const std::string& command) {
                                          return firmware->defectOf(command, settings);
                                        });
}

LineFeed::Source sourceOf(const StreamableProgram& program, const std::shared_ptr<RevisedLines>& revised) {
  if (!revised) return sourceOf(program);
  return [revised] { return revised->next(); };
}

LineFeed::Readiness readinessOf(const std::shared_ptr<RevisedLines>& revised) {
  if (!revised) return {};
  return [revised] { return revised->isNextKnown(); };
}

}  // namespace lamina
