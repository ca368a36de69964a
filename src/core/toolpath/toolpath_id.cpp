// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <cstring>
#include <string>
#include <variant>

#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

/// FNV-1a over 64-bit words instead of bytes: as good to distinguish toolpaths, eight times as fast.
class Fingerprint {
 public:
  void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001B3ULL; }
  void add(double value) {
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof word);
    add(word);
    hash_ ^= hash_ >> 29;
  }
  void add(const Bead& bead) {
    add(bead.width_mm);
    add(bead.height_mm);
  }
  void add(const Eigen::Quaterniond& q) {
    for (int i = 0; i < 4; ++i) add(q.coeffs()[i]);
  }
  template <class Value>
  void add(const AlongPath<Value>& along) {
    add(static_cast<std::uint64_t>(along.values().size()));
    for (const Value& value : along.values()) add(value);
  }
  void add(const Path& path) {
    add(static_cast<std::uint64_t>(path.role));
    add(static_cast<std::uint64_t>(path.is_closed) |
        static_cast<std::uint64_t>(path.process.is_retracted) << 1 |
        static_cast<std::uint64_t>(path.deposit) << 2);
    add(static_cast<std::uint64_t>(path.points.size()));
    for (const Point3& point : path.points)
      for (int i = 0; i < 3; ++i) add(point[i]);
    add(path.orientation);
    add(path.bead);
    add(path.feed_mm_s);
    if (path.tool != 0 || !path.events.empty() || !path.values.empty()) addProcess(path);
  }
  void add(const std::string& text) {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  void add(const ToolpathEvent& event) {
    add(static_cast<std::uint64_t>(event.index()));
    std::visit([this](const auto& kind) { addEvent(kind); }, event);
  }
  std::uint64_t value() const { return hash_; }

 private:
  void addProcess(const Path& path) {
    add(static_cast<std::uint64_t>(path.tool));
    add(static_cast<std::uint64_t>(path.events.size()));
    for (const PathEvent& placed : path.events) {
      add(static_cast<std::uint64_t>(placed.motion));
      add(placed.event);
    }
    for (const ProcessValue& each : path.values) {
      add(each.name);
      add(each.value);
    }
  }
  void addEvent(const Dwell& dwell) { add(dwell.duration_s); }
  void addEvent(const FanShare& fan) { add(fan.share); }
  void addEvent(const OperatorPause& pause) { add(pause.message); }
  void addEvent(const PartMark& mark) { add(mark.name); }
  void addEvent(const MachineCode& code) {
    add(code.text);
    add(static_cast<std::uint64_t>(code.moves_axes));
  }

  std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

}  // namespace

std::string toolpathId(const Toolpath& toolpath) {
  Fingerprint fingerprint;
  fingerprint.add(toolpath.part_name);
  if (isInclined(toolpath)) fingerprint.add(toolpath.part_from_layers);
  for (const ToolpathLayer& layer : toolpath.layers) {
    fingerprint.add(layer.z_mm);
    fingerprint.add(layer.height_mm);
    fingerprint.add(static_cast<std::uint64_t>(layer.paths.size()));
    for (const Path& path : layer.paths) fingerprint.add(path);
  }
  for (const ToolpathEvent& event : toolpath.events_at_end) fingerprint.add(event);
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(fingerprint.value()));
  return text;
}

}  // namespace lamina
