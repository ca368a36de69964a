// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laid_lines.hpp"

#include <ros/console.h>

#include <algorithm>
#include <deque>
#include <mutex>
#include <sstream>
#include <string>
#include <utility>

namespace lamina {

/// Passes everything on, and keeps the lines that were given and are not counted yet: those that are read
/// ahead of what the machine has accepted.
class LaidLines::Counted final : public ProgramRevision {
 public:
  explicit Counted(std::shared_ptr<ProgramRevision> inner) : inner_(std::move(inner)) {}

  bool isKnown(std::int32_t layer) override { return inner_->isKnown(layer); }
  void decide(std::int32_t layer) override { inner_->decide(layer); }
  std::optional<StreamableProgram> successor(std::int32_t layer) override { return inner_->successor(layer); }
  std::optional<RevisionRecord> record() const override { return inner_->record(); }
  std::string recordFailure() const override { return inner_->recordFailure(); }
  double waitTime() const override { return inner_->waitTime(); }
  std::string revised(std::string_view line, std::uint64_t number) override {
    std::string lines = inner_->revised(line, number);
    ProgramCursor cursor(std::make_unique<std::istringstream>(lines));
    const std::lock_guard<std::mutex> lock(mutex_);
    while (auto command = cursor.next()) given_.push_back(std::move(command->command));
    return lines;
  }

  std::optional<std::string> next() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (given_.empty()) return std::nullopt;
    std::string command = std::move(given_.front());
    given_.pop_front();
    return command;
  }

 private:
  std::shared_ptr<ProgramRevision> inner_;
  std::mutex mutex_;
  std::deque<std::string> given_;  ///< guarded by it
};

namespace {

double diameterOf(const StreamableProgram& program, double otherwise_mm) {
  return filamentDiameterOf(*program.openText()).value_or(otherwise_mm);
}

}  // namespace

LaidLines::LaidLines(const StreamableProgram& program, const std::shared_ptr<ProgramRevision>& revision,
                     double filament_diameter_mm)
    : laid_(diameterOf(program, filament_diameter_mm)) {
  if (revision)
    revision_ = std::make_shared<Counted>(revision);
  else
    program_ = program.open();
}

std::shared_ptr<ProgramRevision> LaidLines::revision() const { return revision_; }

std::optional<std::string> LaidLines::nextCommand() {
  if (revision_) return revision_->next();
  auto line = program_->next();
  if (!line) return std::nullopt;
  return std::move(line->command);
}

const LaidFilament& LaidLines::through(std::uint64_t lines, std::uint64_t most) {
  const std::uint64_t end = lines > lines_ ? lines_ + std::min(lines - lines_, most) : lines_;
  for (; lines_ < end; ++lines_) {
    const auto command = nextCommand();
    if (!command) break;
    laid_.take(*command);
  }
  if (!laid_.fault().empty() && !std::exchange(is_fault_logged_, true))
    ROS_WARN_STREAM(
        "how much is laid is not known from a line on that cannot be read for it: " << laid_.fault());
  return laid_;
}

}  // namespace lamina
