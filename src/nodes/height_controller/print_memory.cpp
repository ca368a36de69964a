// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print_memory.hpp"

#include <ros/console.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "lamina/base/error.hpp"

namespace lamina {

void PrintMemory::resume(LoopRun& run) {
  if (!isKept() || !std::filesystem::exists(file_)) return;
  try {
    LoopMemory memory = readLoopMemory(file_);
    run.resume(memory);
    resumed_after_ = memory.layer;
    memory_ = std::move(memory);
    ROS_INFO("the loop goes on after layer %zu, as '%s' has it", *resumed_after_, file_.c_str());
  } catch (const Error& error) {
    ROS_WARN("the loop begins at the first layer: '%s' is not gone on with: %s", file_.c_str(), error.what());
  }
}

std::vector<RaisedAlarm> PrintMemory::stood() const {
  if (!isKept() || !std::filesystem::exists(file_)) return {};
  try {
    return readLoopMemory(file_).standing;
  } catch (const Error&) {
    return {};  // why is said when the print is to go on
  }
}

void PrintMemory::keep(const LoopMemory& memory) {
  memory_ = memory;
  write();
}

void PrintMemory::keepStatus(const LoopStatus& status) {
  if (!memory_) return;
  memory_->status = status;
  write();
}

void PrintMemory::keepStanding(const std::vector<RaisedAlarm>& standing) {
  const auto isEqual = [](const RaisedAlarm& a, const RaisedAlarm& b) {
    return a.alarm == b.alarm && a.reaction == b.reaction && a.reason == b.reason;
  };
  if (!memory_ || std::equal(standing.begin(), standing.end(), memory_->standing.begin(),
                             memory_->standing.end(), isEqual))
    return;
  memory_->standing = standing;
  write();
}

void PrintMemory::forget() {
  resumed_after_.reset();
  if (!memory_) return;
  memory_.reset();
  std::remove(file_.c_str());
}

void PrintMemory::write() {
  if (!isKept() || has_failed_) return;
  try {
    writeLoopMemory(file_, *memory_);
  } catch (const Error& error) {
    has_failed_ = true;  // once is enough to say so
    ROS_ERROR("what the loop knows is no longer kept: %s", error.what());
  }
}

}  // namespace lamina
