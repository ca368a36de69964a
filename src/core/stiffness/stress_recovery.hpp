// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/stiffness/elastic_material.hpp"
#include "lamina/stiffness/element_lattice.hpp"
#include "lamina/stiffness/node_field.hpp"
#include "lamina/stiffness/stress.hpp"

namespace lamina {

/// Stress in the middle of each element, in the order of the runs.
std::vector<Stress> stressOf(const ElementLattice& lattice, const ElasticMaterial& material,
                             double element_mm, const NodeField<double>& displacement);

}  // namespace lamina
