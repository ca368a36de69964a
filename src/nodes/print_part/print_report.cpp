// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print_report.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "conversions.hpp"

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

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  return whole < 60 ? fixed(seconds, 1) + " s"
                    : std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

}  // namespace

HeightError heightError(const std::vector<lamina_msgs::LayerHeight>& layers) {
  HeightError error;
  double cells = 0.0;
  for (const auto& layer : layers) {
    cells += layer.cells;
    error.mean_mm += toMillimetres(layer.mean_error) * layer.cells;
    error.coverage += layer.coverage / static_cast<double>(layers.size());
    const double worst = toMillimetres(layer.worst_error);
    if (std::abs(worst) > std::abs(error.worst_mm)) error.worst_mm = worst;
  }
  if (cells > 0.0) error.mean_mm /= cells;
  return error;
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
  lines.add("layers measured", report.layers.size(), ", mean coverage ", fixed(100.0 * error.coverage, 1),
            " %");
  lines.add("height error", "mean ", fixed(error.mean_mm, 4), " mm, worst ", fixed(error.worst_mm, 4), " mm");
  lines.add("slicing time", duration(slicing.wall_time));
  lines.add("printing time", duration(slicing.estimated_time), " estimated, ",
            duration(report.streaming.duration), " streamed");
  lines.add("wall time", duration(report.wall_time_s));
  return lines.text();
}

}  // namespace lamina
