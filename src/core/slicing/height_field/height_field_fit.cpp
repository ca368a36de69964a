// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/height_field/height_field_fit.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "slicing/height_field/bend_limits.hpp"

namespace lamina {
namespace {

/// Keeps the solution from drifting as a whole; far too weak to bend it.
constexpr double kAnchor = 1e-9;
/// Weight of an even bend where there is no part.
constexpr double kBeside = 1e-6;
constexpr int kMostSolves = 12;
/// Part of the allowed slope to which steeper places are drawn, so that few solves are enough.
constexpr double kDrawn = 0.99;

/// Two neighbouring corners and by how much the solution is to differ between them.
struct Edge {
  std::size_t from = 0;
  std::size_t to = 0;
  double weight = 0.0;
  double difference = 0.0;
};

class Fit {
 public:
  Fit(const TopSurface& top, const HeightGrid& cells, const std::vector<char>& is_followed,
      const HeightFieldSettings& settings)
      : top_(top), cells_(cells), is_followed_(is_followed), settings_(settings) {
    for (int row = 0; row <= cells.rows; ++row)
      for (int column = 0; column < cells.columns; ++column)
        addEdge(corner(column, row), corner(column + 1, row), {column, row}, {column, row - 1});
    for (int row = 0; row < cells.rows; ++row)
      for (int column = 0; column <= cells.columns; ++column)
        addEdge(corner(column, row), corner(column, row + 1), {column, row}, {column - 1, row});
  }

  std::vector<double> solve() && {
    std::vector<double> solution = solved();
    for (int i = 1; i < kMostSolves && drawSteepPlaces(solution); ++i) solution = solved();
    return solution;
  }

 private:
  struct Cell {
    int column = 0;
    int row = 0;
  };

  std::size_t corner(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_.columns + 1) +
           static_cast<std::size_t>(column);
  }

  bool isFollowed(const Cell& at) const {
    return cells_.contains(at.column, at.row) && is_followed_[cells_.cell(at.column, at.row)] != 0;
  }

  bool isPart(const Cell& at) const {
    if (!cells_.contains(at.column, at.row)) return false;
    const std::size_t half = 2 * cells_.cell(at.column, at.row);
    return top_.over_half[half] || top_.over_half[half + 1];
  }

  /// @param one, other  the cells on both sides
  void addEdge(std::size_t from, std::size_t to, const Cell& one, const Cell& other) {
    if (isFollowed(one) || isFollowed(other))
      edges_.push_back({from, to, 1.0, std::log(*top_.prolonged[to] / *top_.prolonged[from])});
    else
      edges_.push_back({from, to, isPart(one) || isPart(other) ? settings_.evenness : kBeside, 0.0});
  }

  std::vector<double> solved() const {
    const auto count = static_cast<Eigen::Index>(top_.at_corner.size());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(count, kAnchor);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(edges_.size() + top_.at_corner.size());
    for (const Edge& edge : edges_) {
      const auto i = static_cast<Eigen::Index>(edge.from);
      const auto j = static_cast<Eigen::Index>(edge.to);
      diagonal[i] += edge.weight;
      diagonal[j] += edge.weight;
      entries.emplace_back(j, i, -edge.weight);  // the lower half of the matrix is enough: from < to
      right[i] -= edge.weight * edge.difference;
      right[j] += edge.weight * edge.difference;
    }
    for (Eigen::Index i = 0; i < count; ++i) entries.emplace_back(i, i, diagonal[i]);
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factorised(matrix);
    const Eigen::VectorXd solution = factorised.solve(right);
    if (factorised.info() != Eigen::Success || !solution.allFinite())
      throw InvalidInput("the height field of " + std::to_string(count) + " corners cannot be solved");
    return {solution.data(), solution.data() + count};
  }

  /// @return whether there are any
  bool drawSteepPlaces(const std::vector<double>& solution) {
    const double allowed = std::tan(settings_.max_slope_deg * M_PI / 180.0);
    std::vector<double> factor(solution.size());
    for (std::size_t i = 0; i < solution.size(); ++i) factor[i] = std::exp(solution[i]);
    bool is_steep = false;
    for (std::size_t half = 0; half < top_.over_half.size(); ++half) {
      const double slope = steepestSlope(factor, cells_, top_, half);
      if (slope <= allowed * (1.0 + 1e-9)) continue;
      is_steep = true;
      const std::array<std::size_t, 3> corners = cornersOfHalf(cells_, half);
      for (std::size_t i = 0; i < 2; ++i) {
        Edge& edge = edges_[edgeFrom(corners[i], corners[i + 1])];
        edge.weight = 4.0 * std::max(edge.weight, 0.25);
        edge.difference = kDrawn * allowed / slope * (solution[edge.to] - solution[edge.from]);
      }
    }
    return is_steep;
  }

  /// In the order in which the edges were added: those along x first.
  std::size_t edgeFrom(std::size_t from, std::size_t to) const {
    const auto columns = static_cast<std::size_t>(cells_.columns);
    if (to == from + 1) return from - from / (columns + 1);
    return columns * static_cast<std::size_t>(cells_.rows + 1) + from;
  }

  const TopSurface& top_;
  const HeightGrid& cells_;
  const std::vector<char>& is_followed_;
  const HeightFieldSettings& settings_;
  std::vector<Edge> edges_;
};

}  // namespace

std::vector<double> fitHeightField(const TopSurface& top, const HeightGrid& cells,
                                   const std::vector<char>& is_followed,
                                   const HeightFieldSettings& settings) {
  return Fit(top, cells, is_followed, settings).solve();
}

}  // namespace lamina
