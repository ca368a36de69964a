// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/planar/plane_index.hpp"

#include <algorithm>

namespace lamina {
namespace {

/// Number of planes below a height. Guesses by the mean distance, which is right for equal layers, and
/// searches otherwise.
class Ranking {
 public:
  explicit Ranking(const std::vector<double>& heights) : heights_(heights) {
    if (heights.size() > 1 && heights.back() > heights.front())
      planes_per_mm_ = static_cast<double>(heights.size() - 1) / (heights.back() - heights.front());
  }

  std::uint32_t operator()(double z) const {
    if (!(heights_.front() < z)) return 0;
    if (heights_.back() < z) return static_cast<std::uint32_t>(heights_.size());
    const auto guess = static_cast<std::size_t>((z - heights_.front()) * planes_per_mm_);
    for (std::size_t rank = std::max<std::size_t>(guess, 1); rank < std::min(guess + 3, heights_.size());
         ++rank)
      if (heights_[rank - 1] < z && z <= heights_[rank]) return static_cast<std::uint32_t>(rank);
    return static_cast<std::uint32_t>(std::lower_bound(heights_.begin(), heights_.end(), z) -
                                      heights_.begin());
  }

 private:
  const std::vector<double>& heights_;
  double planes_per_mm_ = 0.0;
};

struct RankRange {
  std::uint32_t low;
  std::uint32_t high;
};

RankRange ranksOf(const Triangle& t, const std::vector<std::uint32_t>& rank) {
  const auto [low, high] = std::minmax({rank[t[0]], rank[t[1]], rank[t[2]]});
  return {low, high};
}

}  // namespace

PlaneIndex indexPlanes(const Mesh& mesh, const std::vector<double>& heights) {
  PlaneIndex index;
  index.begin.assign(heights.size() + 1, 0);
  if (heights.empty()) return index;
  const Ranking ranking(heights);
  index.rank.reserve(mesh.vertices.size());
  for (const Point3& vertex : mesh.vertices) index.rank.push_back(ranking(vertex.z()));

  // Each triangle is counted where it begins and where it ends; the running sum is the number at each plane.
  std::vector<std::int64_t> change(heights.size() + 1, 0);
  for (const Triangle& t : mesh.triangles) {
    const RankRange range = ranksOf(t, index.rank);
    ++change[range.low];
    --change[range.high];
  }
  std::int64_t at_plane = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    at_plane += change[i];
    index.begin[i + 1] = index.begin[i] + static_cast<std::size_t>(at_plane);
  }
  index.triangles.resize(index.begin.back());
  std::vector<std::size_t> end(index.begin.begin(), index.begin.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const RankRange range = ranksOf(mesh.triangles[t], index.rank);
    for (std::uint32_t plane = range.low; plane < range.high; ++plane) index.triangles[end[plane]++] = t;
  }
  return index;
}

}  // namespace lamina
