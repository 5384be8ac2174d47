#pragma once

#include <QButtonGroup>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMargins>
#include <QScrollArea>
#include <QString>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
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

/// Names an object, so that tests and style sheets find it.
template <class Object>
Object* named(Object* object, const char* name) {
  object->setObjectName(QLatin1String(name));
  return object;
}

/// The same, with what a screen reader says.
template <class Widget>
Widget* named(Widget* widget, const char* name, const QString& accessible_name) {
  widget->setAccessibleName(accessible_name);
  return named(widget, name);
}

/// Sets a property that the style sheet asks for: "muted", "caption", "card" ...
template <class Widget>
Widget* styledAs(Widget* widget, const char* look) {
  widget->setProperty(look, true);
  return widget;
}

/// The names for tests and style sheets, and for screen readers.
inline void setNames(QWidget* widget, const QString& name, const QString& accessible_name) {
  widget->setObjectName(name);
  widget->setAccessibleName(accessible_name);
}

/// Texts that are never read as markup, in as many lines as they need.
inline void setPlainParagraph(QLabel* label) {
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
}

/// A label of this name with such texts.
inline QLabel* paragraph(const char* name, QWidget* parent = nullptr) {
  auto* label = named(new QLabel(parent), name);
  setPlainParagraph(label);
  return label;
}

/// Hidden without a text. What is there already is not laid out anew.
inline void showIfAny(QLabel* label, const QString& text) {
  label->setText(text);
  label->setVisible(!text.isEmpty());
}

/// One of several buttons in a row, of which one is pressed.
inline QToolButton* addChoice(QButtonGroup* group, QHBoxLayout* row, const char* name, const QString& text) {
  auto* button = named(new QToolButton, name);
  button->setText(text);
  button->setCheckable(true);
  group->addButton(button);
  row->addWidget(button);
  return button;
}

/// A button of this name that the keyboard reaches, and that leaves the keys where they were when it is clicked.
template <class Button>
Button* quiet(Button* button, const char* name) {
  button->setFocusPolicy(Qt::TabFocus);
  return named(button, name);
}

/// Makes a timer that, once started, does this once.
template <class Receiver, class Work>
void setUpOnce(QTimer& timer, int after_ms, Receiver* receiver, Work work) {
  timer.setSingleShot(true);
  timer.setInterval(after_ms);
  QObject::connect(&timer, &QTimer::timeout, receiver, work);
}

/// It lies over a view, and whoever points at it points at that.
inline void letThrough(QWidget* overlay) {
  overlay->setAttribute(Qt::WA_TransparentForMouseEvents);
  overlay->setAttribute(Qt::WA_NoSystemBackground);
  overlay->setFocusPolicy(Qt::NoFocus);
}

/// Grey, and then it says why.
inline void enable(QWidget* control, bool can, const QString& purpose, const QString& why_not) {
  control->setEnabled(can);
  control->setToolTip(can ? purpose : why_not);
}

/// In a narrow panel, however long its texts are.
inline void makeNarrow(QComboBox* box) {
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
}

inline void makeBold(QWidget* widget) {
  QFont bold = widget->font();
  bold.setBold(true);
  widget->setFont(bold);
}

/// The words before a field, whose key brings the keyboard to it.
inline QLabel* labelFor(QWidget* field, const QString& text) {
  auto* label = new QLabel(text);
  label->setBuddy(field);
  return label;
}

/// For two fields in a row, each with its label.
inline QGridLayout* gridOfFields() {
  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  return grid;
}

/// A field over so many columns, with its label at its left.
inline void addField(QGridLayout* grid, int row, int column, const QString& text, QWidget* field, int columns = 1) {
  grid->addWidget(labelFor(field, text), row, column);
  grid->addWidget(field, row, column + 1, 1, columns);
}

/// It scrolls up and down only, has no frame of its own, and leaves the focus to what is in it.
inline void scrollPlainly(QScrollArea* area) {
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

/// A table that shows and is not typed into; Tab leaves it.
inline void dressTable(QTableView* table) {
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setShowGrid(false);
  table->setWordWrap(false);
  table->setTabKeyNavigation(false);
  table->setFrameShape(QFrame::NoFrame);
}

/// The same, of whole rows without names.
inline void dressRows(QTableView* table) {
  dressTable(table);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setHighlightSections(false);
}

}  // namespace hexoderm
