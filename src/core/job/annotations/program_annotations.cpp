// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/annotations/program_annotations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lamina/base/base64.hpp"
#include "lamina/job/profiles/stated_settings.hpp"
#include "lamina/picture/thumbnail.hpp"
#include "lamina/toolpath/timing.hpp"
#include "program/gcode/extrusion.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLongestLine = 78;  // characters of base64

const char* nameOf(ImageFormat format) {
  switch (format) {
    case ImageFormat::Png:
      return "thumbnail";
    case ImageFormat::Qoi:
      return "thumbnail_QOI";
    case ImageFormat::Jpeg:
      return "thumbnail_JPG";
  }
  return "";
}

/// As slicers write them, and hosts look for them.
std::string thumbnailComment(const Toolpath& toolpath, const Thumbnail& thumbnail) {
  const std::string name = nameOf(thumbnail.format);
  const std::string picture = base64(drawThumbnail(toolpath, thumbnail));
  std::string text = "; " + name + " begin " + std::to_string(thumbnail.width_px) + "x" +
                     std::to_string(thumbnail.height_px) + " " + std::to_string(picture.size()) + "\n";
  for (std::size_t at = 0; at < picture.size(); at += kLongestLine)
    text += "; " + picture.substr(at, kLongestLine) + "\n";
  return text + "; " + name + " end\n";
}

std::string statedNumber(const char* key, double value) {
  char line[96];
  std::snprintf(line, sizeof line, "; %s = %.2f\n", key, value);
  return line;
}

/// Of the toolpath, without what is pushed forth again after a retraction.
std::string summaryComments(const Toolpath& toolpath, const JobSettings& settings) {
  const double time_s = estimateTime(toolpath, settings.motion).total_s;
  const double deposited_cm3 = settings.program.flow * totals(toolpath).deposited_mm3 / 1e3;
  const double filament_mm = filamentPerVolume(settings.program) * totals(toolpath).deposited_mm3;
  std::string text =
      statedNumber("filament used [mm]", filament_mm) + statedNumber("filament used [cm3]", deposited_cm3);
  if (settings.material.density_g_cm3 > 0.0)
    text += statedNumber("filament used [g]", settings.material.density_g_cm3 * deposited_cm3);
  char height[64];
  std::snprintf(height, sizeof height, "; layer_height = %g\n", settings.slicing.layer_height_mm);
  return text + "; estimated printing time (normal mode) = " + durationText(time_s) + "\n" + height;
}

}  // namespace

ProgramAnnotations annotationsOf(const Toolpath& toolpath, const JobSettings& settings) {
  ProgramAnnotations annotations;
  for (const Thumbnail& thumbnail : thumbnailsFrom(settings.program.thumbnails))
    annotations.head += thumbnailComment(toolpath, thumbnail);
  if (settings.program.states_summary) annotations.tail += summaryComments(toolpath, settings);
  if (settings.program.states_settings) annotations.tail += settingComments(settings);
  return annotations;
}

void writeAnnotated(const ProgramAnnotations& annotations,
                    const std::function<void(const TextSink& sink)>& write, const TextSink& sink) {
  bool is_begun = annotations.head.empty();
  write([&](std::string_view piece) {
    const std::size_t line = piece.find('\n');
    if (is_begun || line == std::string_view::npos) return sink(piece);
    is_begun = true;
    sink(piece.substr(0, line + 1));
    sink(annotations.head);
    sink(piece.substr(line + 1));
  });
  if (!annotations.tail.empty()) sink(annotations.tail);
}

std::string durationText(double time_s) {
  const long long seconds = std::llround(std::max(0.0, time_s));
  const std::pair<long long, const char*> units[] = {
      {seconds / 86400, "d"}, {seconds / 3600 % 24, "h"}, {seconds / 60 % 60, "m"}, {seconds % 60, "s"}};
  std::string text;
  for (const auto& [count, unit] : units)
    if (!text.empty() || count > 0 || *unit == 's')
      text += (text.empty() ? "" : " ") + std::to_string(count) + unit;
  return text;
}

}  // namespace lamina
