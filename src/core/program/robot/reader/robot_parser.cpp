// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/reader/robot_parser.hpp"

#include <utility>

#include "lamina/base/error.hpp"
#include "program/robot/fanuc/fanuc_parser.hpp"
#include "program/robot/inform/inform_parser.hpp"
#include "program/robot/krl/krl_parser.hpp"
#include "program/robot/urscript/urscript_parser.hpp"

namespace lamina {

RobotGrammar robotGrammar(RobotLanguage language) {
  switch (language) {
    case RobotLanguage::Krl:
      return {parseKrl, ";# ", ".src", ".dat"};
    case RobotLanguage::UrScript:
      return {parseUrScript, "## ", ".script", ""};
    case RobotLanguage::Fanuc:
      return {parseFanuc, "!# ", ".ls", ""};
    case RobotLanguage::Inform:
      return {parseInform, "'# ", ".jbi", ""};
  }
  throw InvalidConfig("there is no language number " + std::to_string(static_cast<int>(language)));
}

void StatementList::addComment(std::string_view comment, std::size_t line) {
  if (!NoteGathering::continuesNote(comment)) flush();
  note_.add(comment, line);
}

void StatementList::add(RobotStatement statement, std::size_t line) {
  flush();
  statements_.push_back({std::move(statement), line});
}

bool StatementList::weaveArc(int schedule) {
  flush();
  auto* arc = statements_.empty() ? nullptr : std::get_if<ArcSwitch>(&statements_.back().what);
  if (arc == nullptr || !arc->is_on) return false;
  arc->weave = schedule;
  return true;
}

bool StatementList::openDryCondition() {
  flush();
  if (conditional_) return false;
  conditional_ = statements_.size();
  return true;
}

bool StatementList::closeDryCondition() {
  flush();
  if (!conditional_ || statements_.size() != *conditional_ + 1) return false;
  conditional_.reset();
  const RobotStatement& last = statements_.back().what;
  const auto* output = std::get_if<OutputSwitch>(&last);
  return std::holds_alternative<LevelChange>(last) || (output != nullptr && output->is_on);
}

void StatementList::flush() {
  if (note_.isEmpty()) return;
  const std::size_t line = note_.line();
  statements_.push_back({NoteLine{note_.take()}, line});
}

std::vector<ReadStatement> StatementList::take() {
  flush();
  return std::move(statements_);
}

}  // namespace lamina
