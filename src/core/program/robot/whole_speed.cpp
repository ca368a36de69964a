// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/whole_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/decimals.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/program/robot/speed_rounding.hpp"

namespace lamina {
namespace {

constexpr double kGreatestError = 0.02;  // of a speed
constexpr double kSameError = 1e-9;      // two units that are as good as each other

const SpeedUnit kMillimetresPerSecond = {"mm/sec", 1.0, 1.0, 2000.0};
const SpeedUnit kCentimetresPerMinute = {"cm/min", 10.0 / 60.0, 1.0, 12000.0};
const SpeedUnit kInchesPerMinute = {"inch/min", 25.4 / 60.0, 1.0, 4724.0};
const SpeedUnit kInformMillimetres = {"mm/s", 1.0, 0.1, 1500.0};
const SpeedUnit kInformCentimetres = {"cm/min", 10.0 / 60.0, 0.1, 9000.0};

constexpr double kRoundedShare = 1e-4;  // of a speed: less is not reported

}  // namespace

std::vector<SpeedUnit> speedUnits(RobotLanguage language, const RobotProgramSettings& settings) {
  if (language == RobotLanguage::Fanuc)
    return {kCentimetresPerMinute, kMillimetresPerSecond, kInchesPerMinute};
  if (language != RobotLanguage::Inform) return {};
  const bool is_mm = settings.inform.speed_unit == InformSpeedUnit::MillimetresPerSecond;
  return {is_mm ? kInformMillimetres : kInformCentimetres};
}

SpeedRounding speedRounding(const Toolpath& toolpath, RobotLanguage language,
                            const RobotProgramSettings& settings) {
  SpeedRounding rounding;
  const std::vector<SpeedUnit> units = speedUnits(language, settings);
  if (units.empty()) return rounding;
  const bool has_weld_speed =
      language == RobotLanguage::Fanuc && settings.fanuc.weld_speed == FanucWeldSpeed::Schedule;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        if (has_weld_speed && path.role != PathRole::Travel) continue;
        const double feed_mm_s = path.feed_mm_s.at(path.motionEnd(m));
        const RoundedSpeed speed = roundedSpeed(feed_mm_s, units);
        const double written_mm_s = speed.value * speed.unit.mm_s;
        const double share = std::abs(written_mm_s / feed_mm_s - 1.0);
        rounding.motions += share > kRoundedShare ? 1 : 0;
        if (share <= rounding.greatest_share) continue;
        rounding.greatest_share = share;
        rounding.feed_mm_s = feed_mm_s;
        rounding.written_mm_s = written_mm_s;
      }
  return rounding;
}

RoundedSpeed roundedSpeed(double feed_mm_s, const std::vector<SpeedUnit>& units) {
  RoundedSpeed best;
  double least = std::numeric_limits<double>::infinity();
  for (const SpeedUnit& unit : units) {
    const double steps = std::max(1.0, std::round(feed_mm_s / (unit.mm_s * unit.step)));
    const double value = std::min(steps * unit.step, unit.greatest);
    const double error = std::abs(value * unit.mm_s / feed_mm_s - 1.0);
    if (error >= least - kSameError) continue;
    least = error;
    best = {unit, value};
  }
  if (!(least <= kGreatestError))
    throw InvalidInput("a feed is " + numberText(feed_mm_s) + " mm/s; the nearest that can be written is " +
                       trimmedDecimals(best.value, 3) + " " + best.unit.name + ", " +
                       trimmedDecimals(100.0 * least, 1) + " % off, expected 2 % at most");
  return best;
}

}  // namespace lamina
