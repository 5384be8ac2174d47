#pragma once

#include <QLabel>
#include <QMargins>
#include <QString>
#include <initializer_list>

namespace hexoderm {

// What every panel and dialog does with its parts.

/// `spacing` below 0: the style's.
template <class Layout>
Layout* spaced(Layout* layout, const QMargins& margins, int spacing = -1) {
  layout->setContentsMargins(margins);
  if (spacing >= 0) layout->setSpacing(spacing);
  return layout;
}

template <class Layout>
Layout* spaced(Layout* layout, int spacing) {
  layout->setSpacing(spacing);
  return layout;
}

/// To a layout, a stack or a splitter, one after the other.
template <class Place>
void addWidgets(Place* place, std::initializer_list<QWidget*> widgets) {
  for (QWidget* widget : widgets) place->addWidget(widget);
}

/// `name`: of the object, by which tests and style sheets find it.
inline void setNames(QWidget* widget, const QString& name, const QString& accessible_name) {
  widget->setObjectName(name);
  widget->setAccessibleName(accessible_name);
}

/// Texts that are never read as markup, in as many lines as they need.
inline void setPlainParagraph(QLabel* label) {
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
}

}  // namespace hexoderm
