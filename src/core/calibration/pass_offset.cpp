// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "lag_search.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/calibration/time_offset.hpp"
#include "passes.hpp"

namespace lamina {
namespace {

constexpr double kCoarseShiftMm = 0.1;  // between passes, from one offset tried to the next
constexpr double kFineStepS = 0.0005;
constexpr std::size_t kLeastCells = 20;    // that two passes share
constexpr double kLeastShared = 0.5;       // of the cells that are shared at most
constexpr double kLeastContrast = 1.5;     // of the usual disagreement over the least
constexpr std::size_t kMostTried = 20000;  // offsets
constexpr double kLargestColumn = 1e6;     // of its number
constexpr std::size_t kMostStrips = 8;     // of a pair that are compared

/// What one profile shows in a strip along the travel, with the nozzle at the origin.
struct StripSight {
  double along_mm = 0.0;
  double height_mm = 0.0;
};

/// A profile reduced to strips; strips count from the nozzle.
struct StripProfile {
  double stamp_s = 0.0;
  std::map<int, StripSight> strips;  ///< by their number across the travel
};

/// Heights of one pass in one strip, ascending along the travel.
struct Strip {
  std::vector<double> along_mm;
  std::vector<double> height_mm;
};

using Strips = std::map<int, Strip>;

/// Everything passes are compared by.
struct Comparison {
  Passes passes;
  std::vector<StripProfile> profiles;
  const std::vector<RecordedPose>& poses;
  double column_mm = 0.0;
  double cell_mm = 0.0;
  std::set<int> wanted = {};  ///< strips, counted from the bed, that are compared
};

/// Squared differences of a pair of passes, without the mean of each strip.
struct Disagreement {
  double squares = 0.0;
  std::size_t cells = 0;

  double mean() const { return cells > 0 ? squares / static_cast<double>(cells) : 0.0; }
  void add(const Disagreement& other) {
    squares += other.squares;
    cells += other.cells;
  }
};

double across(const Point3& point, const Point2& travel) {
  return point.x() * travel.y() - point.y() * travel.x();
}

/// @throws InvalidInput if a point lies absurdly far away
StripProfile reduced(const RecordedProfile& profile, const Eigen::Isometry3d& tip_from_sensor,
                     const Point2& travel, double column_mm) {
  struct Sum {
    StripSight sight;
    double count = 0.0;
  };
  std::map<int, Sum> sums;
  for (const Point3& point : profile.points) {
    const Point3 at = tip_from_sensor * point;
    const double column = std::floor(across(at, travel) / column_mm);
    if (!(std::abs(column) < kLargestColumn))
      throw InvalidInput("a point lies " + numberText(at.norm()) +
                         " mm from the nozzle; expected what a sensor on the head can see");
    Sum& sum = sums[static_cast<int>(column)];
    sum.sight.along_mm += at.head<2>().dot(travel);
    sum.sight.height_mm += at.z();
    sum.count += 1.0;
  }
  StripProfile strips{profile.time_s, {}};
  for (const auto& [column, sum] : sums)
    strips.strips[column] = {sum.sight.along_mm / sum.count, sum.sight.height_mm / sum.count};
  return strips;
}

/// Poses at which something may have been seen: what the nozzle does between scans, as in a print, shows
/// nothing.
std::vector<RecordedPose> posesSeenFrom(const SensorRecording& recording, double search_s) {
  std::vector<RecordedPose> seen;
  auto profile = recording.profiles.begin();
  for (const RecordedPose& pose : recording.poses) {
    while (profile != recording.profiles.end() && profile->time_s < pose.time_s - search_s) ++profile;
    if (profile != recording.profiles.end() && profile->time_s <= pose.time_s + search_s)
      seen.push_back(pose);
  }
  return seen;
}

Comparison comparisonOf(const SensorRecording& recording, const PassComparison& settings) {
  Comparison comparison{
      passesOf(posesSeenFrom(recording, settings.search_s)), {}, recording.poses, settings.column_mm, 0.0};
  for (const RecordedProfile& profile : recording.profiles) {
    const double nearest =
        std::clamp(profile.time_s, recording.poses.front().time_s, recording.poses.back().time_s);
    const auto pose = poseAt(recording.poses, nearest);
    if (!pose || profile.points.empty()) continue;
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    turn.linear() = pose->linear();
    comparison.profiles.push_back(
        reduced(profile, turn * settings.nozzle_from_sensor, comparison.passes.travel, settings.column_mm));
  }
  std::vector<double> gaps;
  for (std::size_t i = 1; i < comparison.profiles.size(); ++i)
    gaps.push_back(comparison.profiles[i].stamp_s - comparison.profiles[i - 1].stamp_s);
  if (gaps.empty()) return comparison;
  std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
  comparison.cell_mm = std::max(0.02, comparison.passes.speed_mm_s * gaps[gaps.size() / 2]);
  return comparison;
}

/// Which strip of the bed the nozzle is over.
std::optional<int> columnOf(const Comparison& comparison, const Point3& nozzle) {
  const double column = across(nozzle, comparison.passes.travel) / comparison.column_mm;
  if (!(std::abs(column) < kLargestColumn)) return std::nullopt;
  return static_cast<int>(std::lround(column));
}

/// How far to the right of the first pass the second one lies, as seen along the travel [mm], and the strips
/// that both see.
struct PassPair {
  double aside_mm = 0.0;
  std::vector<int> strips;
};

PassPair pairOf(const Comparison& comparison, std::size_t first) {
  std::array<std::optional<int>, 2> columns;
  std::array<double, 2> aside{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Pass& pass = comparison.passes.runs[first + i];
    const auto pose = poseAt(comparison.poses, 0.5 * (pass.begin_s + pass.end_s));
    if (!pose) return {};
    columns[i] = columnOf(comparison, pose->translation());
    aside[i] = across(pose->translation(), comparison.passes.travel);
  }
  PassPair pair{aside[1] - aside[0], {}};
  if (!columns[0] || !columns[1]) return pair;
  int low = static_cast<int>(kLargestColumn);
  int high = -low;
  for (const StripProfile& profile : comparison.profiles) {
    low = std::min(low, profile.strips.begin()->first);
    high = std::max(high, profile.strips.rbegin()->first);
  }
  const int shared_low = low + std::max(*columns[0], *columns[1]);
  const int shared = high + std::min(*columns[0], *columns[1]) - shared_low + 1;
  const int step = std::max(1, shared / static_cast<int>(kMostStrips));
  for (int i = 0; i < shared; i += step) pair.strips.push_back(shared_low + i);
  return pair;
}

/// What a pass shows if stamps are late by `offset_s`.
Strips stripsOf(const Comparison& comparison, const Pass& pass, double offset_s) {
  Strips strips;
  const auto begin =
      std::lower_bound(comparison.profiles.begin(), comparison.profiles.end(), pass.begin_s + offset_s,
                       [](const StripProfile& profile, double stamp) { return profile.stamp_s < stamp; });
  for (auto profile = begin; profile != comparison.profiles.end(); ++profile) {
    if (profile->stamp_s - offset_s > pass.end_s) break;
    const auto pose = poseAt(comparison.poses, profile->stamp_s - offset_s);
    if (!pose) continue;
    const Point3 nozzle = pose->translation();
    const double along = nozzle.head<2>().dot(comparison.passes.travel);
    const std::optional<int> shift = columnOf(comparison, nozzle);
    if (!shift) continue;
    for (const int column : comparison.wanted) {
      const auto sight = profile->strips.find(column - *shift);
      if (sight == profile->strips.end()) continue;
      Strip& strip = strips[column];
      strip.along_mm.push_back(along + sight->second.along_mm);
      strip.height_mm.push_back(nozzle.z() + sight->second.height_mm);
    }
  }
  for (auto& [column, strip] : strips) {
    if (pass.sense > 0.0) continue;
    std::reverse(strip.along_mm.begin(), strip.along_mm.end());
    std::reverse(strip.height_mm.begin(), strip.height_mm.end());
  }
  return strips;
}

/// Height at a place; the strip's places may be disordered a little by uneven stamps.
double heightAt(const Strip& strip, double along_mm, std::size_t& next) {
  while (next + 1 < strip.along_mm.size() && strip.along_mm[next] < along_mm) ++next;
  const double span = strip.along_mm[next] - strip.along_mm[next - 1];
  const double part = span > 0.0 ? std::clamp((along_mm - strip.along_mm[next - 1]) / span, 0.0, 1.0) : 1.0;
  return strip.height_mm[next - 1] + part * (strip.height_mm[next] - strip.height_mm[next - 1]);
}

Disagreement disagreementOf(const Strip& a, const Strip& b, double cell_mm) {
  if (a.along_mm.size() < 2 || b.along_mm.size() < 2) return {};
  const double low = std::max(a.along_mm.front(), b.along_mm.front());
  const double high = std::min(a.along_mm.back(), b.along_mm.back());
  if (!(high > low)) return {};
  const auto cells = static_cast<std::size_t>(
      std::min((high - low) / cell_mm, 2.0 * static_cast<double>(a.along_mm.size() + b.along_mm.size())));
  double sum = 0.0;
  double squares = 0.0;
  std::size_t next_a = 1;
  std::size_t next_b = 1;
  for (std::size_t i = 0; i < cells; ++i) {
    const double along = low + (static_cast<double>(i) + 0.5) * cell_mm;
    const double difference = heightAt(a, along, next_a) - heightAt(b, along, next_b);
    sum += difference;
    squares += difference * difference;
  }
  if (cells == 0) return {};
  return {std::max(0.0, squares - sum * sum / static_cast<double>(cells)), cells};
}

Disagreement disagreementOf(const Strips& a, const Strips& b, double cell_mm) {
  Disagreement whole;
  for (const auto& [column, strip] : a) {
    const auto other = b.find(column);
    if (other != b.end()) whole.add(disagreementOf(strip, other->second, cell_mm));
  }
  return whole;
}

/// Pairs of passes that follow each other in opposite senses, by the first.
std::vector<std::size_t> pairsOf(const Passes& passes) {
  std::vector<std::size_t> pairs;
  for (std::size_t i = 0; i + 1 < passes.runs.size(); ++i)
    if (passes.runs[i].sense != passes.runs[i + 1].sense) pairs.push_back(i);
  return pairs;
}

/// How much the passes of each pair disagree if stamps are late by `offset_s`.
std::vector<Disagreement> disagreementsAt(const Comparison& comparison, const std::vector<std::size_t>& pairs,
                                          double offset_s) {
  std::map<std::size_t, Strips> strips;
  std::vector<Disagreement> found;
  for (const std::size_t pair : pairs) {
    for (const std::size_t pass : {pair, pair + 1})
      if (strips.find(pass) == strips.end())
        strips[pass] = stripsOf(comparison, comparison.passes.runs[pass], offset_s);
    found.push_back(disagreementOf(strips[pair], strips[pair + 1], comparison.cell_mm));
  }
  return found;
}

/// Disagreement by offsets that were tried; of those with too few cells in common, none.
struct Tried {
  std::vector<double> offset_s;
  std::vector<std::vector<Disagreement>> pairs;  ///< by offset, then by pair
};

Tried tryOffsets(const Comparison& comparison, const std::vector<std::size_t>& pairs, double low_s,
                 double high_s, double step_s) {
  Tried tried;
  const auto count = static_cast<std::size_t>(
      std::min(std::ceil((high_s - low_s) / step_s) + 1.0, static_cast<double>(kMostTried)));
  for (std::size_t i = 0; i < count; ++i) {
    tried.offset_s.push_back(low_s +
                             (high_s - low_s) * static_cast<double>(i) / static_cast<double>(count - 1));
    tried.pairs.push_back(disagreementsAt(comparison, pairs, tried.offset_s.back()));
  }
  return tried;
}

/// Mean disagreement by offset, of all pairs or of one; infinite where too little is shared.
std::vector<double> meansOf(const Tried& tried, const std::vector<std::size_t>& of) {
  std::vector<Disagreement> sums;
  std::size_t most = 0;
  for (const auto& pairs : tried.pairs) {
    Disagreement sum;
    for (const std::size_t pair : of) sum.add(pairs[pair]);
    most = std::max(most, sum.cells);
    sums.push_back(sum);
  }
  std::vector<double> means;
  for (const Disagreement& sum : sums) {
    const bool is_enough = sum.cells >= kLeastCells && static_cast<double>(sum.cells) >= kLeastShared * most;
    means.push_back(is_enough ? sum.mean() : std::numeric_limits<double>::infinity());
  }
  return means;
}

std::size_t leastOf(const std::vector<double>& means) {
  return static_cast<std::size_t>(std::min_element(means.begin(), means.end()) - means.begin());
}

/// The best offset to a fraction of a step, and its deviation by the bend of the disagreement.
struct Vertex {
  double offset_s = 0.0;
  double spread_s = 0.0;
};

/// A parabola fitted through values around the least.
Vertex vertexOf(const Tried& tried, const std::vector<double>& means, std::size_t cells) {
  constexpr std::size_t kReach = 6;
  const std::size_t best = leastOf(means);
  const std::size_t reach = std::min({kReach, best, means.size() - 1 - best});
  if (reach == 0 || !std::isfinite(means[best - reach] + means[best + reach]))
    return {tried.offset_s[best], 0.0};
  const double step_s = tried.offset_s[1] - tried.offset_s[0];
  Eigen::MatrixXd powers(2 * reach + 1, 3);
  Eigen::VectorXd values(2 * reach + 1);
  for (std::size_t i = 0; i <= 2 * reach; ++i) {
    const double place = static_cast<double>(i) - static_cast<double>(reach);
    powers.row(static_cast<Eigen::Index>(i)) << 1.0, place, place * place;
    values[static_cast<Eigen::Index>(i)] = means[best - reach + i];
  }
  if (!values.allFinite()) return {tried.offset_s[best], 0.0};
  const Eigen::Vector3d parabola = (powers.transpose() * powers).ldlt().solve(powers.transpose() * values);
  if (!(parabola[2] > 0.0)) return {tried.offset_s[best], 0.0};
  const double shift = std::clamp(-0.5 * parabola[1] / parabola[2], -1.0 * reach, 1.0 * reach);
  const double spread = std::sqrt(means[best] / (parabola[2] * static_cast<double>(cells)));
  return {tried.offset_s[best] + shift * step_s, spread * step_s};
}

/// Offsets of pairs of one kind.
struct KindOfPairs {
  std::vector<double> offsets_s;
  double aside_mm = 0.0;  ///< mean

  double mean() const { return lineOfValues(offsets_s, offsets_s).mean; }
};

/// A turn of the line delays pairs that lie one way as much as it hastens those that lie the other way.
void combine(TimeOffset& offset, const Comparison& comparison, const std::vector<std::size_t>& pairs) {
  std::array<KindOfPairs, 2> kinds;
  std::vector<double> times;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pass& first = comparison.passes.runs[pairs[i]];
    const double aside = first.sense * pairOf(comparison, pairs[i]).aside_mm;
    KindOfPairs& kind = kinds[aside < 0.0 ? 1 : 0];
    kind.aside_mm += std::abs(aside);
    kind.offsets_s.push_back(offset.pieces_s[i]);
    times.push_back(first.end_s / 60.0);
  }
  const std::size_t count = pairs.size();
  const LineOfValues line = lineOfValues(times, offset.pieces_s);
  offset.drift_s_per_min = line.slope;
  const double aside = (kinds[0].aside_mm + kinds[1].aside_mm) / static_cast<double>(count);
  const bool overlaps = aside > comparison.column_mm;
  offset.is_skew_separable = !overlaps || (!kinds[0].offsets_s.empty() && !kinds[1].offsets_s.empty());
  if (!overlaps || !offset.is_skew_separable) {
    offset.offset_s = line.mean;
    offset.scatter_s = line.deviation;
    return;
  }
  offset.offset_s = 0.5 * (kinds[0].mean() + kinds[1].mean());
  const double apart_s = kinds[0].mean() - kinds[1].mean();
  offset.skew_deg = toDegrees(std::atan(apart_s * comparison.passes.speed_mm_s / aside));
  offset.scatter_s = std::max(lineOfValues(times, kinds[0].offsets_s).deviation,
                              lineOfValues(times, kinds[1].offsets_s).deviation);
}

/// Those of the pairs that see the same ground.
std::vector<std::size_t> sharing(const std::vector<std::size_t>& pairs, const Tried& tried) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto sees = [i](const std::vector<Disagreement>& at) { return at[i].cells >= kLeastCells; };
    if (std::any_of(tried.pairs.begin(), tried.pairs.end(), sees)) kept.push_back(i);
  }
  return kept;
}

/// @throws InvalidInput if no offset stands out among those tried
double coarseOffset(const Tried& tried, const std::vector<std::size_t>& of, double search_s) {
  const std::vector<double> means = meansOf(tried, of);
  const std::size_t best = leastOf(means);
  std::vector<double> finite;
  std::copy_if(means.begin(), means.end(), std::back_inserter(finite),
               [](double mean) { return std::isfinite(mean); });
  std::sort(finite.begin(), finite.end());
  if (finite.empty() || !(finite[finite.size() / 2] > kLeastContrast * means[best]))
    throw InvalidInput("passes agree alike at all offsets; expected an edge or other relief under them");
  if (best == 0 || best + 1 == means.size())
    throw InvalidInput("the best offset lies at the end of the search of " + numberText(search_s) +
                       " s; expected a wider search");
  return tried.offset_s[best];
}

}  // namespace

TimeOffset offsetByPasses(const SensorRecording& recording, const PassComparison& settings) {
  if (recording.poses.size() < 2)
    throw InvalidInput("there are " + std::to_string(recording.poses.size()) +
                       " poses of the nozzle; expected at least 2");
  Comparison comparison = comparisonOf(recording, settings);
  const std::vector<std::size_t> all = pairsOf(comparison.passes);
  if (all.empty() || comparison.profiles.size() < 2)
    throw InvalidInput("the nozzle makes " + std::to_string(comparison.passes.runs.size()) + " passes, and " +
                       std::to_string(comparison.profiles.size()) +
                       " profiles were seen; expected two passes in opposite senses");
  for (const std::size_t pair : all)
    for (const int strip : pairOf(comparison, pair).strips) comparison.wanted.insert(strip);
  const double coarse_s = std::clamp(0.5 * kCoarseShiftMm / comparison.passes.speed_mm_s, kFineStepS, 0.005);
  const Tried coarse = tryOffsets(comparison, all, -settings.search_s, settings.search_s, coarse_s);
  const std::vector<std::size_t> of = sharing(all, coarse);
  if (of.empty())
    throw InvalidInput(
        "no passes in opposite senses see the same ground; expected an edge there and back, or "
        "swaths that overlap");
  const double about_s = coarseOffset(coarse, of, settings.search_s);
  std::vector<std::size_t> pairs;
  pairs.reserve(of.size());
  for (const std::size_t i : of) pairs.push_back(all[i]);
  const double reach_s = 4.0 * coarse_s + 0.02;
  const Tried fine = tryOffsets(comparison, pairs, about_s - reach_s, about_s + reach_s, kFineStepS);
  TimeOffset offset;
  double least_spread_s = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::vector<double> means = meansOf(fine, {i});
    const Vertex vertex = vertexOf(fine, means, fine.pairs[leastOf(means)][i].cells);
    offset.pieces_s.push_back(vertex.offset_s);
    least_spread_s = std::max(least_spread_s, vertex.spread_s);
  }
  combine(offset, comparison, pairs);
  const double count = std::sqrt(static_cast<double>(pairs.size()));
  offset.spread_s = std::max(least_spread_s, offset.scatter_s) / count;
  offset.profiles = comparison.profiles.size();
  const std::vector<double> means = meansOf(coarse, of);
  double usual = 0.0;
  for (const double mean : means) usual = std::isfinite(mean) ? std::max(usual, mean) : usual;
  offset.agreement = std::sqrt(std::max(0.0, 1.0 - means[leastOf(means)] / usual));
  return offset;
}

}  // namespace lamina
