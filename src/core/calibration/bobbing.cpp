// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "lag_search.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/calibration/time_offset.hpp"

namespace lamina {
namespace {

constexpr double kStepS = 0.001;
constexpr long kHalfMeanSteps = 1000;  // of the mean that is taken away
constexpr long kPieces = 10;
constexpr long kPieceSearchSteps = 30;
constexpr long kApartSteps = 50;      // a lag that far from the best one is another one
constexpr double kGapSpacings = 5.0;  // usual ones between values, beyond which some are missing
constexpr double kLeastGapS = 0.02;
constexpr long kLongGapSteps = 250;  // what lies straight over it would change the mean around
constexpr double kLeastKnown = 0.3;  // of the steps
constexpr double kShortestS = 4.0;
constexpr double kLongestS = 600.0;
constexpr double kLeastMotionMm = 0.05;
constexpr double kLeastCorrelation = 0.8;
constexpr double kAsGood = 0.95;        // of the greatest correlation
constexpr double kLeastRatio = 0.5;     // of depths to heights
constexpr double kGreatestRatio = 2.5;  // a sensor that leans by 66 deg

/// A range of steps.
struct Span {
  long begin = 0;
  long end = 0;
};

/// A quantity every `kStepS`; value i belongs to the time (first + i) steps. Values that are left out are
/// NaN.
struct Steps {
  long first = 0;
  std::vector<double> values;
  std::vector<Span> gaps = {};  ///< where nothing was recorded, and values are straight over it

  long end() const { return first + static_cast<long>(values.size()); }
  double at(long step) const { return values[static_cast<std::size_t>(step - first)]; }
};

std::string inSeconds(double seconds) { return numberText(seconds) + " s"; }

/// Time between values beyond which some are missing between them.
double longestSpacing(const std::vector<double>& time_s) {
  std::vector<double> spacings;
  spacings.reserve(time_s.size());
  for (std::size_t i = 1; i < time_s.size(); ++i) spacings.push_back(time_s[i] - time_s[i - 1]);
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return std::max(kLeastGapS, kGapSpacings * *middle);
}

std::vector<Span> gapsOf(const std::vector<double>& time_s) {
  const double longest_s = longestSpacing(time_s);
  std::vector<Span> gaps;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (time_s[i] - time_s[i - 1] <= longest_s) continue;
    gaps.push_back({static_cast<long>(std::floor(time_s[i - 1] / kStepS)) + 1,
                    static_cast<long>(std::ceil(time_s[i] / kStepS))});
  }
  return gaps;
}

/// Straight between values.
/// @param time_s  ascending; at least two
Steps everyStep(const std::vector<double>& time_s, const std::vector<double>& values) {
  const double length_s = time_s.back() - time_s.front();
  if (!(length_s >= kShortestS && length_s <= kLongestS))
    throw InvalidInput("the recording is " + inSeconds(length_s) + " long; expected " +
                       inSeconds(kShortestS) + " to " + inSeconds(kLongestS) + " of bobbing");
  Steps steps;
  steps.first = static_cast<long>(std::ceil(time_s.front() / kStepS));
  const long end = static_cast<long>(std::floor(time_s.back() / kStepS)) + 1;
  std::size_t next = 1;
  for (long step = steps.first; step < end; ++step) {
    const double time = static_cast<double>(step) * kStepS;
    while (next + 1 < time_s.size() && time_s[next] < time) ++next;
    const double span = time_s[next] - time_s[next - 1];
    const double part = span > 0.0 ? (time - time_s[next - 1]) / span : 1.0;
    steps.values.push_back(values[next - 1] + part * (values[next] - values[next - 1]));
  }
  steps.gaps = gapsOf(time_s);
  return steps;
}

/// Leaves out what was not recorded, and what has no mean for that reason.
void leaveOutGaps(Steps& high, const std::vector<Span>& gaps) {
  for (const Span& gap : gaps) {
    const long beside = gap.end - gap.begin > kLongGapSteps ? kHalfMeanSteps : 0;
    const long end = std::min(high.end(), gap.end + beside);
    for (long step = std::max(high.first, gap.begin - beside); step < end; ++step)
      high.values[static_cast<std::size_t>(step - high.first)] = std::numeric_limits<double>::quiet_NaN();
  }
}

/// @param what  was recorded
/// @throws InvalidInput if most of it was not
void requireKnown(const Steps& steps, const std::string& what) {
  const auto known = std::count_if(steps.values.begin(), steps.values.end(),
                                   [](double value) { return std::isfinite(value); });
  const double share = static_cast<double>(known) / static_cast<double>(steps.values.size());
  if (share < kLeastKnown)
    throw InvalidInput(what + " have gaps that leave " + numberText(100.0 * share) +
                       " % of the recording; expected at least " + numberText(100.0 * kLeastKnown) + " %");
}

/// Without the mean of the two seconds around; what has no such mean is left out.
Steps withoutMean(const Steps& steps) {
  std::vector<double> sums(1, 0.0);
  for (const double value : steps.values) sums.push_back(sums.back() + value);
  Steps high{steps.first + kHalfMeanSteps, {}, {}};
  const auto half = static_cast<std::size_t>(kHalfMeanSteps);
  for (std::size_t i = half; i + half < steps.values.size(); ++i)
    high.values.push_back(steps.values[i] - (sums[i + half + 1] - sums[i - half]) / (2.0 * half + 1.0));
  leaveOutGaps(high, steps.gaps);
  return high;
}

Steps heightsOf(const SensorRecording& recording, double zero_s) {
  std::vector<double> times;
  std::vector<double> heights;
  for (const RecordedPose& pose : recording.poses) {
    times.push_back(pose.time_s - zero_s);
    heights.push_back(pose.bed_from_nozzle.translation().z());
  }
  Steps steps = withoutMean(everyStep(times, heights));
  requireKnown(steps, "poses of the nozzle");
  return steps;
}

/// The profiles with points that any lag within the search leads to a pose.
std::vector<const RecordedProfile*> profilesBeside(const SensorRecording& recording, double search_s) {
  const double begin_s = recording.poses.front().time_s - search_s;
  const double end_s = recording.poses.back().time_s + search_s;
  std::vector<const RecordedProfile*> beside;
  beside.reserve(recording.profiles.size());
  for (const RecordedProfile& profile : recording.profiles)
    if (!profile.points.empty() && profile.time_s >= begin_s && profile.time_s <= end_s)
      beside.push_back(&profile);
  if (beside.empty() && !recording.profiles.empty())
    throw InvalidInput("profiles begin " + inSeconds(recording.profiles.front().time_s - begin_s - search_s) +
                       " after the poses of the nozzle; expected stamps of one clock");
  return beside;
}

Steps depthsOf(const std::vector<const RecordedProfile*>& profiles, double zero_s) {
  std::vector<double> times;
  std::vector<double> depths;
  for (const RecordedProfile* profile : profiles) {
    double sum = 0.0;
    for (const Point3& point : profile->points) sum += point.z();
    times.push_back(profile->time_s - zero_s);
    depths.push_back(sum / static_cast<double>(profile->points.size()));
  }
  if (times.size() < 2)
    throw InvalidInput("there are " + std::to_string(times.size()) + " profiles; expected at least 2");
  Steps steps = withoutMean(everyStep(times, depths));
  requireKnown(steps, "profiles");
  return steps;
}

/// The steps of the heights at which there are depths a lag later.
Span shared(const Steps& heights, const Steps& depths, long lag, Span within) {
  return {std::max({heights.first, depths.first - lag, within.begin}),
          std::min({heights.end(), depths.end() - lag, within.end})};
}

/// Correlation of heights with the depths a lag later; 0 where there is nothing to correlate.
double correlationAt(const Steps& heights, const Steps& depths, long lag, Span within) {
  const Span span = shared(heights, depths, lag, within);
  double both = 0.0;
  double squared_height = 0.0;
  double squared_depth = 0.0;
  for (long step = span.begin; step < span.end; ++step) {
    const double height = heights.at(step);
    const double depth = depths.at(step + lag);
    if (std::isnan(height * depth)) continue;
    both += height * depth;
    squared_height += height * height;
    squared_depth += depth * depth;
  }
  const double scale = std::sqrt(squared_height * squared_depth);
  return scale > 0.0 ? both / scale : 0.0;
}

/// Correlations at lags from -search to search.
std::vector<double> correlations(const Steps& heights, const Steps& depths, long search) {
  const Span all{heights.first, heights.end()};
  const long least = std::min(heights.end() - heights.first, depths.end() - depths.first) / 2;
  std::vector<double> found;
  for (long lag = -search; lag <= search; ++lag) {
    const Span span = shared(heights, depths, lag, all);
    found.push_back(span.end - span.begin >= least ? correlationAt(heights, depths, lag, all) : 0.0);
  }
  return found;
}

/// @throws InvalidInput if another lag agrees as well
void requireOneBest(const std::vector<double>& found, std::size_t best) {
  for (std::size_t i = 1; i + 1 < found.size(); ++i) {
    const auto apart = static_cast<long>(i) - static_cast<long>(best);
    const bool is_peak = found[i] >= found[i - 1] && found[i] >= found[i + 1];
    if (std::abs(apart) >= kApartSteps && is_peak && found[i] > kAsGood * found[best])
      throw InvalidInput("a lag " + inSeconds(static_cast<double>(apart) * kStepS) +
                         " from the best one agrees as well: the motion repeats itself; expected bobbing of "
                         "a frequency that changes, or a narrower search");
  }
}

/// By a correlation any unit would do: here depths follow heights one to one, or somewhat more where the
/// sensor leans.
/// @throws InvalidInput if they do not
void requireUnit(const Steps& heights, const Steps& depths, long lag) {
  const Span span = shared(heights, depths, lag, {heights.first, heights.end()});
  double both = 0.0;
  double squared_height = 0.0;
  for (long step = span.begin; step < span.end; ++step) {
    const double product = heights.at(step) * depths.at(step + lag);
    if (std::isnan(product)) continue;
    both += product;
    squared_height += heights.at(step) * heights.at(step);
  }
  const double ratio = both / squared_height;
  if (ratio < kLeastRatio || ratio > kGreatestRatio)
    throw InvalidInput("depths change by " + numberText(ratio) +
                       " mm for each mm of the nozzle's height; expected 1, or up to " +
                       numberText(kGreatestRatio) +
                       " of a sensor that leans: are the clouds in metres, or tables in mm?");
}

/// Root mean square of heights, and of their rate.
struct Motion {
  double height_mm = 0.0;
  double rate_mm_s = 0.0;
};

Motion motionOf(const Steps& heights, Span span) {
  Motion motion;
  double count = 0.0;
  for (long step = span.begin; step + 1 < span.end; ++step) {
    const double rate = (heights.at(step + 1) - heights.at(step)) / kStepS;
    if (std::isnan(rate)) continue;
    motion.height_mm += heights.at(step) * heights.at(step);
    motion.rate_mm_s += rate * rate;
    count += 1.0;
  }
  count = std::max(1.0, count);
  return {std::sqrt(motion.height_mm / count), std::sqrt(motion.rate_mm_s / count)};
}

double refinedLag(const Steps& heights, const Steps& depths, long lag, Span within) {
  return kStepS *
         (static_cast<double>(lag) + vertexOfParabola(correlationAt(heights, depths, lag - 1, within),
                                                      correlationAt(heights, depths, lag, within),
                                                      correlationAt(heights, depths, lag + 1, within)));
}

/// Whether at least half of a span has heights, and depths a lag later.
bool isMostlyKnown(const Steps& heights, const Steps& depths, long lag, Span span) {
  long known = 0;
  for (long step = span.begin; step < span.end; ++step)
    known += std::isnan(heights.at(step) + depths.at(step + lag)) ? 0 : 1;
  return 2 * known >= span.end - span.begin;
}

/// The offset by each tenth that was recorded and in which the nozzle moves enough.
void addPieces(TimeOffset& offset, const Steps& heights, const Steps& depths, long best) {
  const Span whole = shared(heights, depths, best, {heights.first, heights.end()});
  const double usual_mm = motionOf(heights, whole).height_mm;
  std::vector<double> times;
  for (long piece = 0; piece < kPieces; ++piece) {
    const long length = whole.end - whole.begin;
    const Span span{whole.begin + piece * length / kPieces, whole.begin + (piece + 1) * length / kPieces};
    if (!isMostlyKnown(heights, depths, best, span)) continue;
    if (motionOf(heights, span).height_mm < 0.3 * usual_mm) continue;
    long lag = best;
    double greatest = -1.0;
    for (long tried = best - kPieceSearchSteps; tried <= best + kPieceSearchSteps; ++tried) {
      const double correlation = correlationAt(heights, depths, tried, span);
      if (correlation > greatest) lag = tried;
      greatest = std::max(greatest, correlation);
    }
    times.push_back(0.5 * static_cast<double>(span.begin + span.end) * kStepS / 60.0);
    offset.pieces_s.push_back(refinedLag(heights, depths, lag, span));
  }
  const LineOfValues line = lineOfValues(times, offset.pieces_s);
  offset.scatter_s = line.deviation;
  offset.drift_s_per_min = line.slope;
}

}  // namespace

TimeOffset offsetByBobbing(const SensorRecording& recording, double search_s) {
  if (recording.poses.size() < 2)
    throw InvalidInput("there are " + std::to_string(recording.poses.size()) +
                       " poses of the nozzle; expected at least 2");
  const double zero_s = recording.poses.front().time_s;
  const Steps heights = heightsOf(recording, zero_s);
  const std::vector<const RecordedProfile*> profiles = profilesBeside(recording, search_s);
  const Steps depths = depthsOf(profiles, zero_s);
  const Motion motion = motionOf(heights, {heights.first, heights.end()});
  if (motion.height_mm < kLeastMotionMm)
    throw InvalidInput("the nozzle's height changes by " + numberText(motion.height_mm) +
                       " mm rms; expected bobbing of at least " + numberText(kLeastMotionMm) + " mm");
  const auto search = static_cast<long>(std::ceil(search_s / kStepS));
  const std::vector<double> found = correlations(heights, depths, search);
  const auto best = static_cast<std::size_t>(std::max_element(found.begin(), found.end()) - found.begin());
  if (found[best] < kLeastCorrelation)
    throw InvalidInput("profiles follow the nozzle's height with a correlation of " +
                       numberText(found[best]) + "; expected at least " + numberText(kLeastCorrelation) +
                       ": is the place flat and in range, and do stamps agree within the search of " +
                       inSeconds(search_s) + "?");
  if (best == 0 || best + 1 == found.size())
    throw InvalidInput("the best lag lies at the end of the search of " + inSeconds(search_s) +
                       "; expected a wider search");
  requireOneBest(found, best);
  TimeOffset offset;
  offset.agreement = found[best];
  offset.profiles = profiles.size();
  const long lag = static_cast<long>(best) - search;
  requireUnit(heights, depths, lag);
  offset.offset_s = refinedLag(heights, depths, lag, {heights.first, heights.end()});
  addPieces(offset, heights, depths, lag);
  const double noise_mm = motion.height_mm * std::sqrt(std::max(0.0, 1.0 - found[best] * found[best]));
  const double by_noise = noise_mm / (motion.rate_mm_s * std::sqrt(static_cast<double>(offset.profiles)));
  const auto pieces = static_cast<double>(std::max<std::size_t>(1, offset.pieces_s.size()));
  offset.spread_s = std::max(by_noise, offset.scatter_s / std::sqrt(pieces));
  return offset;
}

}  // namespace lamina
