// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fields/role_legend.hpp"

#include <QColor>
#include <QString>

#include "lamina/picture/toolpath_picture.hpp"

namespace lamina {

RoleLegend::RoleLegend(QWidget* parent) : QLabel(parent) {
  setObjectName("legend");
  setWordWrap(true);
  setTextFormat(Qt::RichText);
  hide();
}

void RoleLegend::setRoles(const std::vector<PathRole>& roles) {
  QString text;
  for (const PathRole role : roles) {
    if (role == PathRole::Travel) continue;
    const Colour colour = roleColour(role);
    text += QString("<span style='color:%1'>&#9632;</span>&nbsp;%2 ")
                .arg(QColor::fromRgbF(colour.red, colour.green, colour.blue).name(),
                     QString(toString(role)).replace("_", "&nbsp;"));
  }
  setText(text);
  setVisible(!text.isEmpty());
}

}  // namespace lamina
