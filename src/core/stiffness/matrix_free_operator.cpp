// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/matrix_free_operator.hpp"

#include <algorithm>
#include <memory>

#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr int kColumns = 128;  // of a batch: two of the longest runs
constexpr int kLayers = 4;     // of elements in a block that one task deals with

/// What stands before the modes: derivatives, volumes and the transforms taken together.
template <class Real>
struct ModeFactors {
  Real lambda;  ///< of the mean strain
  Real two_mu;
  Real mu;
  Real third_lambda;  ///< of strains that vary along one axis
  Real mu_whole;      ///< 3 mu / 3
  Real third_mu;
  Real ninth;  ///< (lambda + 4 mu) / 9
};

template <class Real>
ModeFactors<Real> modeFactors(const ElasticMaterial& material, double scale) {
  const double lambda = material.lambda() * scale;
  const double mu = material.mu() * scale;
  return {Real(lambda),
          Real(2.0 * mu),
          Real(mu),
          Real(lambda / 3.0),
          Real(mu),
          Real(mu / 3.0),
          Real((lambda + 4.0 * mu) / 9.0)};
}

/// A batch of columns of four nodes each, (j, k), (j+1, k), (j, k+1), (j+1, k+1), along x.
template <class Real>
struct Columns {
  alignas(64) Real in[3][4][kColumns + 16];    ///< 1, y, z, yz of each component
  alignas(64) Real even[3][4][kColumns + 16];  ///< forces alike on both columns of an element; of 1 none
  alignas(64) Real odd[3][4][kColumns + 16];   ///< forces opposite on both columns of an element
};

template <class Real>
void gather(const ElementRun& run, int at, const std::array<const Real*, 3>& u, Columns<Real>& columns) {
  for (int c = 0; c < 3; ++c) {
    const Real* __restrict n00 = u[std::size_t(c)] + run.node[0];
    const Real* __restrict n10 = u[std::size_t(c)] + run.node[1];
    const Real* __restrict n01 = u[std::size_t(c)] + run.node[2];
    const Real* __restrict n11 = u[std::size_t(c)] + run.node[3];
    Real* __restrict one = columns.in[c][0] + at;
    Real* __restrict y = columns.in[c][1] + at;
    Real* __restrict z = columns.in[c][2] + at;
    Real* __restrict yz = columns.in[c][3] + at;
    const int count = run.count + 1;
    for (int i = 0; i < count; ++i) {
      const Real low_sum = n10[i] + n00[i];
      const Real low_difference = n10[i] - n00[i];
      const Real high_sum = n11[i] + n01[i];
      const Real high_difference = n11[i] - n01[i];
      one[i] = high_sum + low_sum;
      y[i] = high_difference + low_difference;
      z[i] = high_sum - low_sum;
      yz[i] = high_difference - low_difference;
    }
  }
}

template <class Real>
void scatter(const ElementRun& run, int at, const Columns<Real>& columns, const std::array<Real*, 3>& f) {
  for (int c = 0; c < 3; ++c) {
    Real* __restrict n00 = f[std::size_t(c)] + run.node[0];
    Real* __restrict n10 = f[std::size_t(c)] + run.node[1];
    Real* __restrict n01 = f[std::size_t(c)] + run.node[2];
    Real* __restrict n11 = f[std::size_t(c)] + run.node[3];
    // Entry i of `even` and `odd` is of the element left of column i.
    const auto& even = columns.even[c];
    const auto& odd = columns.odd[c];
    const int count = run.count + 1;
    for (int i = 0; i < count; ++i) {
      const int left = at + i;
      const int right = left + 1;
      const Real one = odd[0][left] - odd[0][right];
      const Real y = (even[1][right] - odd[1][right]) + (even[1][left] + odd[1][left]);
      const Real z = (even[2][right] - odd[2][right]) + (even[2][left] + odd[2][left]);
      const Real yz = (even[3][right] - odd[3][right]) + (even[3][left] + odd[3][left]);
      const Real low = one - z;
      const Real high = one + z;
      const Real low_y = y - yz;
      const Real high_y = y + yz;
      n00[i] += low - low_y;
      n10[i] += low + low_y;
      n01[i] += high - high_y;
      n11[i] += high + high_y;
    }
  }
}

/// Displacements of columns to forces on them, element by element.
template <class Real>
void applyModes(const float* __restrict density, int count, const ModeFactors<Real>& s,
                Columns<Real>& columns) {
  const auto& in = columns.in;
  auto& even = columns.even;
  auto& odd = columns.odd;
  for (int i = 0; i < count; ++i) {
    const auto rho = Real(density[i]);
    const auto sum = [&](int c, int m) { return in[c][m][i + 1] + in[c][m][i]; };
    const auto difference = [&](int c, int m) { return in[c][m][i + 1] - in[c][m][i]; };
    const Real ax = difference(0, 0), by = sum(1, 1), cz = sum(2, 2);
    const Real trace = s.lambda * (ax + by + cz);
    odd[0][0][i + 1] = rho * (trace + s.two_mu * ax);
    even[1][1][i + 1] = rho * (trace + s.two_mu * by);
    even[2][2][i + 1] = rho * (trace + s.two_mu * cz);
    const Real xy = rho * s.mu * (sum(0, 1) + difference(1, 0));
    even[0][1][i + 1] = xy;
    odd[1][0][i + 1] = xy;
    const Real yz = rho * s.mu * (sum(1, 2) + sum(2, 1));
    even[1][2][i + 1] = yz;
    even[2][1][i + 1] = yz;
    const Real zx = rho * s.mu * (sum(0, 2) + difference(2, 0));
    even[0][2][i + 1] = zx;
    odd[2][0][i + 1] = zx;
    const Real a_xy = difference(0, 1), c_yz = sum(2, 3), of_y = s.third_lambda * (a_xy + c_yz);
    odd[0][1][i + 1] = rho * (of_y + s.mu_whole * a_xy);
    even[2][3][i + 1] = rho * (of_y + s.mu_whole * c_yz);
    const Real b_xy = difference(1, 1), c_xz = difference(2, 2), of_x = s.third_lambda * (b_xy + c_xz);
    odd[1][1][i + 1] = rho * (of_x + s.mu_whole * b_xy);
    odd[2][2][i + 1] = rho * (of_x + s.mu_whole * c_xz);
    const Real a_xz = difference(0, 2), b_yz = sum(1, 3), of_z = s.third_lambda * (a_xz + b_yz);
    odd[0][2][i + 1] = rho * (of_z + s.mu_whole * a_xz);
    even[1][3][i + 1] = rho * (of_z + s.mu_whole * b_yz);
    const Real a_yz = sum(0, 3), b_xz = difference(1, 2), c_xy = difference(2, 1);
    const Real twist = a_yz + b_xz + c_xy;
    const Real third = rho * s.third_mu;
    even[0][3][i + 1] = third * (twist + a_yz);
    odd[1][2][i + 1] = third * (twist + b_xz);
    odd[2][1][i + 1] = third * (twist + c_xy);
    const Real ninth = rho * s.ninth;
    odd[0][3][i + 1] = ninth * difference(0, 3);
    odd[1][3][i + 1] = ninth * difference(1, 3);
    odd[2][3][i + 1] = ninth * difference(2, 3);
  }
}

/// Adds the forces of rows of elements, one after the other.
template <class Real>
class RowProduct {
 public:
  RowProduct(const ElasticElements& elements, double factor, const NodeField<Real>& displacement,
             NodeField<Real>& force)
      : lattice_(elements.lattice),
        factors_(modeFactors<Real>(elements.material, factor * elements.element_mm / 16.0)),
        displacement_(displacement.pointers()),
        force_(force.pointers()),
        columns_(std::make_unique<Columns<Real>>()) {}

  void add(int row) {
    const ElementRun* const end = lattice_.elementsEnd(row);
    for (const ElementRun* first = lattice_.elementsBegin(row); first != end;) {
      int count = 0;
      const ElementRun* last = first;
      for (; last != end && count + last->count + 1 <= kColumns; count += last++->count + 1)
        gather(*last, count, displacement_, *columns_);
      applyModes(lattice_.density().data() + first->column, count, factors_, *columns_);
      for (int at = 0; first != last; at += first++->count + 1) scatter(*first, at, *columns_, force_);
    }
  }

 private:
  const ElementLattice& lattice_;
  ModeFactors<Real> factors_;
  std::array<const Real*, 3> displacement_;
  std::array<Real*, 3> force_;
  std::unique_ptr<Columns<Real>> columns_;
};

}  // namespace

template <class Real>
void addForces(const ElasticElements& elements, double factor, const NodeField<Real>& displacement,
               NodeField<Real>& force) {
  const ElementLattice& lattice = elements.lattice;
  const int layers = lattice.count()[2];
  const int rows = lattice.count()[1];
  const int blocks = (layers + kLayers - 1) / kLayers;
  // Blocks of layers touch only their neighbours: first the even ones, then the odd ones.
  for (int parity = 0; parity < 2; ++parity)
    parallelFor(std::size_t(blocks + 1 - parity) / 2, [&](std::size_t b) {
      RowProduct<Real> product(elements, factor, displacement, force);
      const int first = (2 * static_cast<int>(b) + parity) * kLayers;
      for (int k = first; k < std::min(layers, first + kLayers); ++k)
        for (int j = 0; j < rows; ++j) product.add(lattice.elementRow(j, k));
    });
}

template void addForces(const ElasticElements&, double, const NodeField<float>&, NodeField<float>&);
template void addForces(const ElasticElements&, double, const NodeField<double>&, NodeField<double>&);

double diagonalOfElement(const ElasticMaterial& material, double element_mm) {
  return element_mm * (material.lambda() + 4.0 * material.mu()) / 9.0;
}

std::vector<float> densityAround(const ElementLattice& lattice) {
  std::vector<float> around(static_cast<std::size_t>(lattice.nodeCount()));
  const int rows = lattice.count()[1] * lattice.count()[2];
  for (int row = 0; row < rows; ++row)
    for (const ElementRun* run = lattice.elementsBegin(row); run != lattice.elementsEnd(row); ++run) {
      const float* density = lattice.density().data() + run->column;
      for (const std::int32_t node : run->node) {
        float* at = around.data() + node;
        for (std::int32_t i = 0; i < run->count; ++i) {
          at[i] += density[i];
          at[i + 1] += density[i];
        }
      }
    }
  return around;
}

}  // namespace lamina
