#include "app/window/toolkit/table_views.h"

#include <QHeaderView>
#include <QLabel>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QTimer>

namespace hexoderm {
namespace {

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

}  // namespace

QTableView* makeTable(QAbstractItemModel* model, const char* object_name, const QString& accessible_name) {
  auto* view = new QTableView;
  view->setObjectName(QLatin1String(object_name));
  view->setAccessibleName(accessible_name);
  view->setModel(model);
  view->setSelectionBehavior(QAbstractItemView::SelectRows);
  view->setSelectionMode(QAbstractItemView::SingleSelection);
  view->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view->setShowGrid(false);
  view->setWordWrap(false);
  view->setTabKeyNavigation(false);
  view->setFrameShape(QFrame::NoFrame);
  view->verticalHeader()->hide();
  view->horizontalHeader()->setHighlightSections(false);
  view->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  // Measuring every row of a large skin on each update would take longer than solving it.
  view->horizontalHeader()->setResizeContentsPrecision(40);
  return view;
}

void stretchColumn(QTableView* view, int column) {
  view->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
}

void wrapRows(QTableView* view) {
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

TableOrHint::TableOrHint(QTableView* view, const QString& hint) : hint_(hint), label_(new QLabel(hint)) {
  label_->setProperty("hint", true);
  label_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  label_->setWordWrap(true);
  addWidget(view);
  addWidget(label_);
  const auto choose = [this, view] { setCurrentIndex(view->model()->rowCount() > 0 ? 0 : 1); };
  connect(view->model(), &QAbstractItemModel::modelReset, this, choose);
  choose();
}

void TableOrHint::setAwaited(const QString& awaited) { label_->setText(awaited.isEmpty() ? hint_ : awaited); }

}  // namespace hexoderm
