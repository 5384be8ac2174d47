#pragma once

#include "widgets/controls/panel_parts.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QStackedWidget>
#include <QString>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QTimer>
#include <QToolTip>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

class QAbstractItemModel;

namespace hexoderm {

/// Shows the whole of a text that is cut short, above what the model says of it.
class WholeTextDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override {
    const QString text = index.data(Qt::DisplayRole).toString();
    const QString tip = index.data(Qt::ToolTipRole).toString();
    const bool is_cut = !text.isEmpty() && sizeHint(option, index).width() > view->visualRect(index).width();
    if (event->type() != QEvent::ToolTip || !is_cut || tip == text || tip.startsWith(QLatin1Char('<'))) {
      return QStyledItemDelegate::helpEvent(event, view, option, index);
    }
    QToolTip::showText(event->globalPos(), tip.isEmpty() ? text : text + QStringLiteral("\n\n") + tip,
                       view->viewport());
    return true;
  }
};

/// Leaves columns out as the table gets narrower, and takes them in again as it gets wider.
class ColumnChoice : public QObject {
 public:
  ColumnChoice(QTableView* view, std::vector<int> columns, int stretched)
      : QObject(view), view_(view), columns_(std::move(columns)), stretched_(stretched) {
    view_->viewport()->installEventFilter(this);
    connect(view_->model(), &QAbstractItemModel::modelReset, this, &ColumnChoice::choose, Qt::QueuedConnection);
  }
  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
    if (event->type() == QEvent::Resize) choose();
    return false;
  }

 private:
  void choose() {
    constexpr int kLabel = 18;  // characters
    int needed = kLabel * view_->fontMetrics().averageCharWidth();
    // A column that is left out has none.
    const auto width = [this](int column) {
      const int now = std::max(view_->horizontalHeader()->sectionSizeHint(column), view_->columnWidth(column));
      if (!view_->isColumnHidden(column)) widths_[column] = now;
      return widths_[column];
    };
    for (int column = 0; column < view_->model()->columnCount(); ++column) {
      if (column != stretched_) needed += width(column);
    }
    for (const int column : columns_) {
      const bool is_left_out = needed > view_->viewport()->width();
      if (is_left_out) needed -= width(column);
      if (view_->isColumnHidden(column) != is_left_out) view_->setColumnHidden(column, is_left_out);
    }
  }

  QTableView* view_;
  std::vector<int> columns_;
  int stretched_;
  std::map<int, int> widths_;  ///< of the columns, as they last were
};

/// Qt asks how high a text is in the whole width of its column, and then draws it beside the style sheet's padding: a
/// line that fits by a hair would be elided instead of wrapped.
class WrappingDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    constexpr int kPadding_px = 6;
    QStyleOptionViewItem narrower = option;
    if (option.rect.width() > kPadding_px) narrower.rect.setWidth(option.rect.width() - kPadding_px);
    return QStyledItemDelegate::sizeHint(narrower, index);
  }
};

/// A table of whole rows, one picked at a time, nothing edited. A text that is cut short stands whole in its tool tip.
inline QTableView* makeTable(QAbstractItemModel* model, const char* object_name, const QString& accessible_name) {
  auto* view = named(new QTableView, object_name);
  view->setAccessibleName(accessible_name);
  view->setModel(model);
  dressRows(view);
  view->setSelectionMode(QAbstractItemView::SingleSelection);
  view->setItemDelegate(new WholeTextDelegate(view));
  constexpr int kAroundText_px = 9;
  view->verticalHeader()->setDefaultSectionSize(view->fontMetrics().height() + kAroundText_px);
  view->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  // Measuring every row of a large skin on each update would take longer than solving it.
  view->horizontalHeader()->setResizeContentsPrecision(40);
  return view;
}
/// One column takes the room that the others leave.
inline void stretchColumn(QTableView* view, int column) {
  view->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
}
/// Long texts take as many lines as they need, as long as measuring them is quick.
inline void wrapRows(QTableView* view) {
  static constexpr int kManyRows = 300;
  view->setWordWrap(true);
  view->setItemDelegate(new WrappingDelegate(view));
  view->setTextElideMode(Qt::ElideRight);
  const auto choose = [view] {
    view->verticalHeader()->setSectionResizeMode(view->model()->rowCount() <= kManyRows ? QHeaderView::ResizeToContents
                                                                                        : QHeaderView::Fixed);
  };
  QObject::connect(view->model(), &QAbstractItemModel::modelReset, view, choose);
  choose();
  // Qt asks for heights when rows come, and not when the text has less room or more.
  auto* again = new QTimer(view);
  again->setSingleShot(true);
  QObject::connect(again, &QTimer::timeout, view, [view] {
    if (view->model()->rowCount() <= kManyRows) view->verticalHeader()->resizeSections(QHeaderView::ResizeToContents);
  });
  QObject::connect(view->horizontalHeader(), &QHeaderView::sectionResized, again, [again] { again->start(); });
}
/// Where the table is too narrow for all of its columns, `columns` are left out, the first ones first, so that
/// `stretched` keeps room for a word.
inline void leaveOutWhereNarrow(QTableView* view, const std::vector<int>& columns, int stretched) {
  new ColumnChoice(view, columns, stretched);
}
/// The table, or a word on why it is empty.
class TableOrHint : public QStackedWidget {
 public:
  /// Takes over the view.
  TableOrHint(QTableView* view, const QString& hint) : hint_(hint), label_(new QLabel(hint)) {
    label_->setProperty("hint", true);
    label_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label_->setWordWrap(true);
    addWidget(view);
    addWidget(label_);
    const auto choose = [this, view] { setCurrentIndex(view->model()->rowCount() > 0 ? 0 : 1); };
    connect(view->model(), &QAbstractItemModel::modelReset, this, choose);
    choose();
  }
  /// What is going on while there is nothing to show, in words, which stand in the hint's place; empty: nothing is.
  void setAwaited(const QString& awaited) { label_->setText(awaited.isEmpty() ? hint_ : awaited); }

 private:
  QString hint_;
  QLabel* label_;
};

}  // namespace hexoderm
