// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/five_axis/five_axis_letters.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::string_view kLetters = "XYZABC";

char letterOf(const DrivenJoint& joint, const std::string& machine) {
  const bool is_letter = joint.name.size() == 1;
  const char letter = is_letter ? static_cast<char>(joint.name[0] - 'a' + 'A') : '?';
  const std::string_view fitting = kLetters.substr(joint.kind == JointKind::Linear ? 0 : 3, 3);
  if (fitting.find(letter) == std::string_view::npos)
    throw InvalidConfig("joint '" + joint.name + "' of '" + machine +
                        "' has no letter in G-code; expected linear joints x, y, z and rotary ones a, b, c");
  return letter;
}

}  // namespace

std::vector<AxisLetter> axisLetters(const KinematicModel& machine) {
  std::vector<AxisLetter> letters;
  for (std::size_t j = 0; j < machine.joints().size(); ++j) {
    const DrivenJoint& joint = machine.joints()[j];
    letters.push_back({letterOf(joint, machine.name()), joint.kind, static_cast<Eigen::Index>(j)});
  }
  std::sort(letters.begin(), letters.end(), [](const AxisLetter& a, const AxisLetter& b) {
    return kLetters.find(a.letter) < kLetters.find(b.letter);
  });
  const std::string text = toText(letters);
  if (text.substr(0, 5) != "X Y Z")
    throw InvalidConfig("'" + machine.name() + "' has the axes " + text + "; expected X, Y and Z among them");
  return letters;
}

std::string toText(const std::vector<AxisLetter>& letters) {
  std::string text;
  for (const AxisLetter& axis : letters) {
    if (!text.empty()) text += ' ';
    text += axis.letter;
  }
  return text;
}

}  // namespace lamina
