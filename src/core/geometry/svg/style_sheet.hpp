// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// The value of a key among declarations as "fill:none;stroke:#000", without "!important"; empty if they have
/// none.
std::string declaredIn(std::string_view declarations, std::string_view key);

/// The rules in the `style` elements of a drawing whose selector is a class (".cls-1") or the name of an
/// element
/// ("path"). Others are ignored, and so is what XML comments hold.
class StyleSheet {
 public:
  StyleSheet() = default;
  /// @param svg  the whole drawing
  explicit StyleSheet(std::string_view svg);

  /// What the last rule that has the key states, of one of the classes before those of the element; empty if
  /// none does.
  /// @param classes  names with blanks, tabs or ends of lines between them
  std::string property(std::string_view element, std::string_view classes, std::string_view key) const;

 private:
  struct Rule {
    std::string selector;
    std::string declarations;
  };

  void read(std::string_view css);

  std::vector<Rule> rules_;
};

}  // namespace lamina
