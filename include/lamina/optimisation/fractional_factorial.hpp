// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"

namespace lamina {

/// A regular fraction of a two-level factorial design.
struct FractionalFactorial {
  std::vector<DesignPoint> points;
  /// Length of the shortest word of the defining relation. At III, main effects are confounded with
  /// interactions of two variables; at IV, interactions of two variables only with each other; at V, no two
  /// of these effects are confounded. 0 if nothing is confounded.
  int resolution = 0;
  std::vector<std::string> defining_words;  ///< the whole relation: "abcd", "-abe"
};

/// A design of two levels, low and high, of each variable. Variables without a generator take all
/// combinations of both, in standard order with the last one fastest. The other variables follow from their
/// generators: "d=abc" sets the fourth variable high where the product of the first three signs is positive,
/// "d=-abc" where it is negative. Letters a, b, c ... are the variables in order. The levels of Continuous
/// and Integer variables are their bounds.
/// @param generators  separated by commas or spaces; none for the full two-level factorial
/// @throws InvalidConfig naming the variable if one has more than two levels or choices (mixed levels need a
///   full factorial), or the generator if it cannot be read, gives a variable twice, refers to one that has a
///   generator, or makes two variables indistinguishable; or if there would be more than a million points
FractionalFactorial fractionalFactorial(const DesignSpace& space, const std::string& generators);

}  // namespace lamina
