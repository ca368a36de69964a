// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The colours of what is shown, with the roles they stand for.
class RoleLegend : public QLabel {
 public:
  explicit RoleLegend(QWidget* parent);

  /// In this order; travels are left out. Hidden if there are none.
  void setRoles(const std::vector<PathRole>& roles);
};

}  // namespace lamina
