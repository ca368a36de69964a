// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/five_axis/five_axis_letters.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::string_view kLetters = "XYZABCUVW";
constexpr std::string_view kRotaryLetters = "ABCUVW";

[[noreturn]] void refuseRenaming(const std::string& renamed, const std::string& why) {
  throw InvalidConfig(
      "five_axis.letters is '" + renamed + "'" + why +
      "; expected rotary joints of the machine, each with a letter of A, B, C, U, V, W of its own, "
      "as \"b=U,c=V\"");
}

/// Gives joints the letters that they are renamed to.
void rename(std::vector<AxisLetter>& letters, const KinematicModel& machine, const std::string& renamed) {
  std::string_view rest = renamed;
  while (!rest.empty()) {
    const std::string_view each = trimmed(rest.substr(0, rest.find(',')));
    rest.remove_prefix(std::min(rest.size(), std::min(rest.find(','), rest.size()) + 1));
    const bool is_one =
        each.size() == 3 && each[1] == '=' && kRotaryLetters.find(each[2]) != std::string_view::npos;
    if (!is_one) refuseRenaming(renamed, "");
    const auto found = std::find_if(letters.begin(), letters.end(), [&](const AxisLetter& axis) {
      return axis.kind != JointKind::Linear &&
             machine.joints()[static_cast<std::size_t>(axis.joint)].name == each.substr(0, 1);
    });
    if (found == letters.end()) refuseRenaming(renamed, "");
    found->letter = each[2];
  }
  for (const AxisLetter& axis : letters)
    if (std::count_if(letters.begin(), letters.end(),
                      [&](const AxisLetter& other) { return other.letter == axis.letter; }) > 1)
      refuseRenaming(renamed, std::string(", which gives the letter ") + axis.letter + " twice");
}

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

std::vector<AxisLetter> axisLetters(const KinematicModel& machine, const std::string& renamed) {
  std::vector<AxisLetter> letters;
  for (std::size_t j = 0; j < machine.joints().size(); ++j) {
    const DrivenJoint& joint = machine.joints()[j];
    letters.push_back({letterOf(joint, machine.name()), joint.kind, static_cast<Eigen::Index>(j)});
  }
  rename(letters, machine, renamed);
  std::sort(letters.begin(), letters.end(), [](const AxisLetter& a, const AxisLetter& b) {
    return kLetters.find(a.letter) < kLetters.find(b.letter);
  });
  const std::string text = toText(letters);
  if (text.substr(0, 5) != "X Y Z")
    throw InvalidConfig("'" + machine.name() + "' has the axes " + text + "; expected X, Y and Z among them");
  return letters;
}

std::vector<AxisLetter> moduloLetters(const KinematicModel& machine, const FiveAxisSettings& settings) {
  if (settings.turns == FiveAxisTurns::Counted) return {};
  if (settings.dialect != FiveAxisDialect::Fanuc && settings.dialect != FiveAxisDialect::Siemens)
    throw InvalidConfig(
        "five_axis.turns is 'modulo' in a dialect other than 'fanuc' and 'siemens'; expected 'counted': only "
        "these "
        "take the shorter way to an angle within one turn");
  std::vector<AxisLetter> letters = axisLetters(machine, settings.letters);
  const auto hasEnd = [&](const AxisLetter& axis) {
    const DrivenJoint& joint = machine.joints()[static_cast<std::size_t>(axis.joint)];
    return axis.kind == JointKind::Linear || std::isfinite(joint.low) || std::isfinite(joint.high);
  };
  letters.erase(std::remove_if(letters.begin(), letters.end(), hasEnd), letters.end());
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
