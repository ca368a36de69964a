// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/machine_reports.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <sstream>

#include "lamina/base/text.hpp"
#include "startup/startup_code.hpp"

namespace lamina {
namespace {

// Over less, the steps in which the target is raised would be taken for the rate [s].
constexpr double kRateWindow = 120.0;

/// What follows a label that stands at the start of the text or after a space.
std::optional<std::string_view> after(std::string_view text, const std::string& label) {
  if (label.empty()) return std::nullopt;
  for (std::size_t at = text.find(label); at != std::string_view::npos; at = text.find(label, at + 1))
    if (at == 0 || text[at - 1] == ' ') return trimmed(text.substr(at + label.size()));
  return std::nullopt;
}

std::optional<double> numberAfter(std::string_view text, const std::string& label) {
  const auto rest = after(text, label);
  if (!rest) return std::nullopt;
  const std::string number(rest->substr(0, 32));
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  return end == number.c_str() ? std::nullopt : std::optional<double>(value);
}

bool isIndex(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The heights of a row of the grid, "2 +0.100 -0.050"; none if the text is no such row.
std::vector<double> rowOf(std::string_view text) {
  const std::vector<std::string> words = splitIntoWords(std::string(text));
  std::vector<double> heights;
  if (words.size() < 2 || !isIndex(words[0])) return heights;
  for (std::size_t i = 1; i < words.size(); ++i) {
    char* end = nullptr;
    heights.push_back(std::strtod(words[i].c_str(), &end));
    if (*end != '\0' || isIndex(words[i])) return {};
  }
  return heights;
}

}  // namespace

MachineReports::MachineReports(const StartupSettings& settings)
    : dryer_label_(settings.dry_label), homed_label_(settings.home_label) {
  for (const int zone : vacuumZones(settings))
    zone_labels_[zone] = filled(settings.vacuum_label, "{zone}", std::to_string(zone));
}

void MachineReports::read(const FirmwareReply& reply, double now_s) {
  if (reply.temperatures && reply.temperatures->bed_c) readBed(*reply.temperatures->bed_c, now_s);
  readLabels(reply.text, now_s);
  if (reply.kind == ReplyKind::Ok) is_in_grid_ = false;
  readHeights(reply.text);
}

void MachineReports::watchBed() {
  window_start_.reset();
  fastest_bed_c_min_ = 0.0;
}

void MachineReports::readBed(double bed_c, double now_s) {
  bed_c_ = bed_c;
  if (!window_start_) window_start_ = TimedTemperature{now_s, bed_c};
  const double passed = now_s - window_start_->time_s;
  if (passed < kRateWindow) return;
  fastest_bed_c_min_ = std::max(fastest_bed_c_min_, (bed_c - window_start_->value_c) / passed * 60.0);
  window_start_ = TimedTemperature{now_s, bed_c};
}

void MachineReports::readLabels(std::string_view text, double now_s) {
  if (const auto dryer = numberAfter(text, dryer_label_)) dryer_ = TimedTemperature{now_s, *dryer};
  for (const auto& [zone, label] : zone_labels_)
    if (const auto kpa = numberAfter(text, label)) zone_kpa_[zone] = *kpa;
  if (const auto letters = after(text, homed_label_)) homed_ = std::string(*letters);
}

void MachineReports::readHeights(std::string_view text) {
  if (text.find("Leveling Grid") != std::string_view::npos) {
    is_in_grid_ = true;
    heights_.reset();
    return;
  }
  if (!is_in_grid_) return;
  for (const double height : rowOf(text)) {
    if (!heights_) heights_ = BedHeights{height, height, 0};
    heights_->low_mm = std::min(heights_->low_mm, height);
    heights_->high_mm = std::max(heights_->high_mm, height);
    ++heights_->points;
  }
}

}  // namespace lamina
