#pragma once

#include "widgets/controls/panel_parts.h"
#include "widgets/controls/selection.h"
#include "widgets/tables/result_table.h"
#include "widgets/tables/row_picking.h"
#include "widgets/tables/sorted_table.h"
#include "widgets/tables/table_csv.h"
#include "widgets/verify/verify_words.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <initializer_list>
#include <utility>

namespace hexoderm {

/// One check of a calibration: what it asks, its controls, its verdict in a sentence, and the figures behind it. A row
/// that is picked picks its cell or link.
class VerifySection : public QFrame {
  Q_OBJECT

 public:
  /// `name` is for objects inside of it and the file that its table is saved as.
  VerifySection(const QString& heading, const QString& question, const QString& name, Selection* selection)
      : selection_(selection) {
    setNames(this, name, heading);
    auto* title = new QLabel(heading);
    makeBold(title);
    auto* asked = styledAs(new QLabel(question), "muted");
    asked->setWordWrap(true);
    spaced(new QVBoxLayout(rows_), {0, 0, 0, 0}, 5);

    auto* bar = new QProgressBar;
    bar->setRange(0, 0);
    bar->setTextVisible(false);
    bar->setAccessibleName(tr("Working"));
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName(name + QStringLiteral("Cancel"));
    connect(cancel, &QPushButton::clicked, this, &VerifySection::cancelled);
    auto* progress = spaced(new QHBoxLayout(progress_), {0, 0, 0, 0});
    progress->addWidget(bar, 1);
    progress->addWidget(cancel);
    progress_->hide();

    sign_->setAlignment(Qt::AlignTop);
    sentence_->setObjectName(name + QStringLiteral("Sentence"));
    setPlainParagraph(sentence_);
    sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* said = spaced(new QHBoxLayout, 7);
    said->addWidget(sign_);
    said->addWidget(sentence_, 1);

    setNames(view_, name + QStringLiteral("Table"), tr("Figures: %1").arg(heading));
    view_->setModel(sorted_);
    dressRows(view_);
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    view_->horizontalHeader()->setResizeContentsPrecision(40);
    SortedTable::enableIn(view_);
    view_->hide();
    csv_actions_ = new CsvActions(view_, name);
    onPicked(view_, this, [this](const QModelIndex& picked) { pick(sorted_->mapToSource(picked).row()); });
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
      if (!view_->selectionModel()->hasSelection()) pick(-1);
    });

    auto* layout = spaced(new QVBoxLayout(this), {0, 0, 0, 0}, 5);
    addWidgets(layout, {title, asked, rows_, progress_});
    layout->addLayout(said);
    layout->addWidget(view_);
    constexpr int kBlink_ms = 200;
    setUpOnce(patience_, kBlink_ms, this, [this] {
      progress_->show();
      paintSentence();
    });
    paintSentence();
  }

  /// A new row of controls; with some, they stand at its left.
  QHBoxLayout* addRow(std::initializer_list<QWidget*> controls = {}) {
    auto* row = spaced(new QHBoxLayout, 6);
    addWidgets(row, controls);
    if (controls.size() > 0) row->addStretch();
    static_cast<QVBoxLayout*>(rows_->layout())->addLayout(row);
    return row;
  }

  void setSentence(const VerifySentence& sentence) {
    said_ = sentence;
    paintSentence();
  }

  /// No rows: no table.
  void setMetrics(VerifyMetrics figures) {
    table_->setContent(std::move(figures.columns), std::move(figures.rows));
    const int rows = table_->rowCount();
    view_->setVisible(rows > 0);
    if (rows == 0) return;
    constexpr int kColumnsThatFit = 3;
    const bool fits = table_->columnCount() <= kColumnsThatFit;
    view_->horizontalHeader()->setSectionResizeMode(fits ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
    constexpr int kMaxRowsSeen = 8;
    const int shown = std::min(rows, kMaxRowsSeen);
    const int bar = view_->horizontalScrollBar()->sizeHint().height();
    view_->setFixedHeight(view_->horizontalHeader()->sizeHint().height() +
                          shown * view_->verticalHeader()->defaultSectionSize() + bar);
  }

  /// Says and shows nothing.
  void clear() {
    setMetrics({});
    setSentence({});
  }

  /// Shows that it is being worked on, with a button to cancel that, once it takes longer than a blink.
  void setRunning(bool running) {
    running_ = running;
    if (running) {
      if (!patience_.isActive() && progress_->isHidden()) patience_.start();
      return;
    }
    patience_.stop();
    progress_->hide();
    paintSentence();
  }

  [[nodiscard]] bool isRunning() const { return running_; }
  [[nodiscard]] CsvActions* csvActions() const { return csv_actions_; }

 signals:
  void cancelled();
  /// The row of the figures as they were given; -1: none.
  void rowPicked(int row);

 private:
  void paintSentence() {
    sign_->setText(toneSign(said_.tone));
    setTone(sign_, said_.tone);
    sentence_->setText(said_.text);
    const bool says = !said_.text.isEmpty() && progress_->isHidden();
    sign_->setVisible(says);
    sentence_->setVisible(says);
  }

  void pick(int row) {
    if (row >= 0) {
      const ResultTable::Row& picked = table_->rowAt(row);
      if (picked.link) {
        selection_->selectLink(picked.link->first, picked.link->second);
      } else if (picked.cell) {
        selection_->selectCell(*picked.cell);
      }
    }
    emit rowPicked(row);
  }

  Selection* selection_;
  QWidget* rows_ = new QWidget;
  QWidget* progress_ = new QWidget;
  QLabel* sign_ = new QLabel;
  QLabel* sentence_ = new QLabel;
  QTableView* view_ = new QTableView;
  ResultTable* table_ = new ResultTable(this);
  SortedTable* sorted_ = new SortedTable(table_, this);
  CsvActions* csv_actions_;
  VerifySentence said_;
  bool running_ = false;
  QTimer patience_;
};

}  // namespace hexoderm
