// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/bead_solid.hpp"

namespace lamina {
namespace {

constexpr double kTurnsBack = -0.9;  // cosine of the sharpest turn that is mitred

/// The lines of a sweep, moved to the middle of the bead.
class SweepLines {
 public:
  explicit SweepLines(const Sweep& sweep) : sweep_(sweep) {}

  std::size_t count() const { return sweep_.lineCount(); }
  Point3 up(std::size_t line) const { return sweep_.up[line + 1]; }
  Point3 start(std::size_t line) const { return middle(line, line); }
  Point3 end(std::size_t line) const { return middle(line + 1, line); }
  Point3 direction(std::size_t line) const { return (end(line) - start(line)).normalized(); }

  /// The line that follows, or as many as there are.
  std::size_t after(std::size_t line) const {
    if (line + 1 < count()) return line + 1;
    return sweep_.is_loop ? 0 : count();
  }
  bool hasCorner(std::size_t line) const { return after(line) != count(); }
  bool isMitred(std::size_t line) const {
    return hasCorner(line) && direction(line).dot(direction(after(line))) > kTurnsBack;
  }
  /// Normal of the plane between a line and the one after it.
  Point3 cornerNormal(std::size_t line) const {
    if (!isMitred(line)) return direction(line);
    return (direction(line) + direction(after(line))).normalized();
  }

 private:
  Point3 middle(std::size_t point, std::size_t line) const {
    return sectionMiddle(sweep_.points[point], sweep_.bead.height_mm, up(line));
  }

  const Sweep& sweep_;
};

BeadSolid prismOf(const SweepLines& lines, std::size_t line, const Bead& bead) {
  const std::size_t before = line > 0 ? line - 1 : lines.count() - 1;
  const bool is_mitred = lines.after(before) == line && lines.isMitred(before);
  const Point3 start_normal = is_mitred ? lines.cornerNormal(before) : lines.direction(line);
  return BeadSolid::prism({lines.start(line), -start_normal}, {lines.end(line), lines.cornerNormal(line)},
                          lines.up(line), bead);
}

/// Whether the sweep ends at a corner of its trajectory: where another sweep of it begins.
bool endsAtCorner(const std::vector<Sweep>& sweeps, std::size_t index, std::size_t first) {
  const Sweep& sweep = sweeps[index];
  const bool is_last = index + 1 == sweeps.size() || sweeps[index + 1].trajectory != sweep.trajectory;
  if (!is_last) return true;
  return first != index && (sweep.points.back() - sweeps[first].points.front()).norm() < 1e-6;
}

}  // namespace

std::vector<BeadSolid> beadSolids(const std::vector<Sweep>& sweeps, CornerStrategy corners) {
  std::vector<BeadSolid> solids;
  std::size_t first = 0;  // sweep of the trajectory
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const Sweep& sweep = sweeps[i];
    if (sweep.trajectory != sweeps[first].trajectory) first = i;
    const SweepLines lines(sweep);
    for (std::size_t line = 0; line < lines.count(); ++line) {
      solids.push_back(prismOf(lines, line, sweep.bead));
      const bool turns_back = lines.hasCorner(line) && !lines.isMitred(line);
      const bool is_revolved = corners == CornerStrategy::Revolved && endsAtCorner(sweeps, i, first);
      if (turns_back || is_revolved)
        solids.push_back(BeadSolid::joint(lines.end(line), lines.up(line), sweep.bead));
    }
  }
  return solids;
}

}  // namespace lamina
