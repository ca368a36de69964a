// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/math/policies/policy.hpp>

namespace lamina {

/// Policy of distributions that are computed as doubles. The `long double` that Boost takes by itself makes
/// every program that loads the core compute constants for it as it starts.
using PlainDoubles = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

}  // namespace lamina
