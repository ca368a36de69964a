// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print_report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "conversions.hpp"
#include "lamina/base/text.hpp"
#include "lamina/toolpath/scan_height.hpp"

namespace lamina {
namespace {

constexpr double kCubicCentimetresPerCubicMetre = 1e6;

class Lines {
 public:
  template <class... Parts>
  void add(const char* name, const Parts&... parts) {
    text_ << std::left << std::setw(18) << name;
    (text_ << ... << parts) << "\n";
  }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string listed(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (const std::size_t number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
  return text;
}

std::string duration(double seconds) {
  constexpr double kShort = 0.1;  // s
  if (seconds < kShort) return fixed(1e3 * seconds, 1) + " ms";
  const auto whole = static_cast<long>(std::lround(seconds));
  return whole < 60 ? fixed(seconds, 1) + " s"
                    : std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

}  // namespace

HeightError heightError(const std::vector<lamina_msgs::LayerHeight>& layers) {
  HeightError error;
  double cells = 0.0;
  for (const auto& layer : layers) {
    if (layer.sight == lamina_msgs::LayerHeight::NOT_SEEN) continue;
    ++error.layers;
    cells += layer.cells;
    error.mean_mm += toMillimetres(layer.mean_error) * layer.cells;
    error.coverage += layer.coverage;
    const double worst = toMillimetres(layer.worst_error);
    if (std::abs(worst) > std::abs(error.worst_mm)) error.worst_mm = worst;
  }
  if (cells > 0.0) error.mean_mm /= cells;
  if (error.layers > 0) error.coverage /= static_cast<double>(error.layers);
  return error;
}

std::vector<std::size_t> scannedLayers(const Toolpath& toolpath, double clearance_mm) {
  std::vector<std::size_t> layers;
  for (std::size_t i = 0; i < toolpath.layers.size(); ++i)
    if (isScanned(toolpath.layers[i], clearance_mm)) layers.push_back(i);
  return layers;
}

std::vector<std::size_t> layersNotSeen(const PrintReport& report) {
  std::vector<std::size_t> layers = report.unreported;
  for (const auto& layer : report.layers)
    if (layer.sight == lamina_msgs::LayerHeight::NOT_SEEN) layers.push_back(layer.layer);
  std::sort(layers.begin(), layers.end());
  return layers;
}

std::string measurementFault(const PrintReport& report) {
  std::vector<std::size_t> layers = layersNotSeen(report);
  for (const auto& layer : report.layers)
    if (layer.sight == lamina_msgs::LayerHeight::CUT_SHORT) layers.push_back(layer.layer);
  std::sort(layers.begin(), layers.end());
  if (layers.empty() && report.has_everything) return "";
  if (layers.empty())
    return "layer_height_monitor did not receive the last position and profile of the machine; expected both";
  return countedSubject(layers.size(), "layer") + " not seen or cut short: " + listed(layers) +
         "; expected every layer with a scan pass to be measured";
}

std::string unplacedText(const lamina_msgs::ProfileCounts& counts) {
  const std::pair<std::uint64_t, const char*> causes[] = {{counts.lost, "lost on the way"},
                                                          {counts.without_frame, "without frame or stamp"},
                                                          {counts.malformed, "malformed"},
                                                          {counts.without_transform, "without transform"},
                                                          {counts.without_nozzle, "without nozzle pose"},
                                                          {counts.pushed_out, "pushed out of the queue"},
                                                          {counts.in_gap, "in gaps of poses"},
                                                          {counts.late, "too late"}};
  std::string text;
  for (const auto& [count, cause] : causes)
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + cause;
  return text;
}

std::string summaryText(const PrintReport& report) {
  const auto& slicing = report.slicing;
  const HeightError error = heightError(report.layers);
  Lines lines;
  lines.add("part", report.part, ", ", slicing.triangles, " triangles");
  for (const std::string& repair : slicing.repairs) lines.add("repaired", repair);
  lines.add("toolpath", report.toolpath_id);
  lines.add("layers", slicing.layers);
  lines.add("deposition", fixed(slicing.deposition, 2), " m in ", slicing.deposition_runs, " runs, ",
            fixed(slicing.deposited_volume * kCubicCentimetresPerCubicMetre, 2), " cm³");
  if (slicing.unprinted_volume > 0.0)
    lines.add("unprinted", fixed(slicing.unprinted_volume * kCubicCentimetresPerCubicMetre, 4),
              " cm³, too small or too thin for the fill");
  lines.add("travel", fixed(slicing.travel, 2), " m");
  lines.add("lines streamed", report.streaming.lines_acknowledged);
  lines.add("resends", report.streaming.resends);
  lines.add("layers measured", error.layers, ", mean coverage ", fixed(100.0 * error.coverage, 1), " %");
  const std::vector<std::size_t> not_seen = layersNotSeen(report);
  if (!not_seen.empty()) lines.add("layers not seen", not_seen.size(), ": ", listed(not_seen));
  const auto cut_short = std::count_if(report.layers.begin(), report.layers.end(), [](const auto& layer) {
    return layer.sight == lamina_msgs::LayerHeight::CUT_SHORT;
  });
  if (cut_short > 0) lines.add("layers cut short", cut_short);
  const std::string unplaced = unplacedText(report.counts);
  lines.add("profiles", report.counts.received, unplaced.empty() ? "" : "; not placed: ", unplaced);
  lines.add("height error", "mean ", fixed(error.mean_mm, 4), " mm, worst ", fixed(error.worst_mm, 4), " mm");
  lines.add("slicing time", duration(slicing.wall_time));
  lines.add("printing time", duration(slicing.estimated_time), " estimated, ",
            duration(report.streaming.duration), " streamed");
  lines.add("wall time", duration(report.wall_time_s));
  return lines.text();
}

}  // namespace lamina
