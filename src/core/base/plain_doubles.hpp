// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/math/policies/policy.hpp>

namespace lamina {

/// Policy by which Boost computes distributions as doubles. With its default, `long double`, every program
/// that loads the core would compute constants at its start.
using PlainDoubles = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

}  // namespace lamina
