// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/web/cell_desk.hpp"

namespace lamina::test {

/// A cell that notes what it is asked, and answers as it is set to.
class FakeDesk final : public CellDesk {
 public:
  CellSnapshot seen;
  ShownDeviation picture;
  std::optional<LayerPreview> shown_layer;
  bool is_being_read = false;  ///< the program of that layer
  DeskAnswer next;
  std::string uploaded;  ///< bytes of the last program

  std::vector<std::string> orders() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return orders_;
  }

  CellSnapshot snapshot() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return seen;
  }
  ShownDeviation deviation() const override { return picture; }
  ShownPreview preview(std::int32_t layer) override {
    return {is_being_read, shown_layer && shown_layer->layer == layer ? shown_layer : std::nullopt};
  }
  DeskAnswer command(const DeskCommand& command) override {
    return take(std::string(toString(command.command)) + " by " + command.source +
                (command.expected_sequence ? " at " + std::to_string(*command.expected_sequence) : "") +
                (command.cut_off == 0 ? "" : " cut_off " + std::to_string(command.cut_off)) +
                (command.confirmed.steps.empty() ? "" : " confirmed " + listed(command.confirmed.steps)) +
                (command.confirmed.begin_mm ? " from " + numberText(*command.confirmed.begin_mm) : ""));
  }
  DeskAnswer changeMode(int mode, const std::string& source) override {
    return take("mode " + std::to_string(mode) + " by " + source);
  }
  DeskAnswer setPlcAccess(PlcAccess access, const std::string& source) override {
    return take((access == PlcAccess::Allowed ? "PLC allowed by " : "PLC locked by ") + source);
  }
  DeskAnswer moveByHand(const DeskManual& order) override {
    std::ostringstream text;
    text << "by hand " << static_cast<int>(order.kind) << " lease " << order.who.lease << " by "
         << order.who.source << ' ' << order.step.frame << ' ' << order.step.axis << ' ' << order.step.step
         << ' ' << order.step.speed;
    return take(text.str());
  }
  DeskAnswer enqueue(const DeskProgram& program) override {
    const std::string bytes = readFile(program.path);
    const std::lock_guard<std::mutex> lock(mutex_);
    uploaded = bytes;
    orders_.push_back("enqueue " + program.name + " by " + program.source);
    DeskAnswer answer = next;
    answer.job = 7;
    return answer;
  }
  DeskAnswer enqueueMesh(const DeskMesh& mesh) override {
    std::string order = "slice " + mesh.name + " of " + mesh.material + " by " + mesh.process;
    for (const SettingText& setting : mesh.settings) order += ", " + setting.key + " " + setting.text;
    DeskAnswer answer = take(order + " for " + mesh.source);
    answer.job = 8;
    return answer;
  }
  DeskAnswer changeQueue(QueueChange change, std::int64_t job, const std::string& source) override {
    return take("change " + std::to_string(static_cast<int>(change)) + " of " + std::to_string(job) + " by " +
                source);
  }
  DeskAnswer moveJob(std::int64_t job, std::int64_t place, const std::string& source) override {
    return take("move " + std::to_string(job) + " to " + std::to_string(place) + " by " + source);
  }
  DeskAnswer acknowledge(int alarm, const std::string& source) override {
    return take("acknowledge " + std::to_string(alarm) + " by " + source);
  }
  DeskAnswer confirmRemoval(const std::string& source) override { return take("removal by " + source); }
  DeskAnswer judge(const DeskVerdict& verdict) override {
    return take("verdict of " + std::to_string(verdict.job) + ": " + verdict.verdict + " by " +
                verdict.source + ", " + verdict.reason);
  }
  DeskAnswer startup(StartupCommand command, const std::string& step) override {
    return take("startup " + std::to_string(static_cast<int>(command)) + " " + step);
  }
  DeskAnswer setLoop(ShownLoopRequest request) override {
    return take("loop " + std::to_string(static_cast<int>(request)));
  }
  void report(int alarm, double /*value*/, const std::string& message) override {
    take("report " + std::to_string(alarm) + ": " + message);
  }

 private:
  DeskAnswer take(std::string order) {
    const std::lock_guard<std::mutex> lock(mutex_);
    orders_.push_back(std::move(order));
    return next;
  }

  mutable std::mutex mutex_;
  std::vector<std::string> orders_;
};

}  // namespace lamina::test
