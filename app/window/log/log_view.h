#pragma once

#include "app/window/log/event_log.h"
#include "hexoderm/base/finding.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/of_enum.h"
#include "widgets/tables/column_table.h"
#include "widgets/words/formatting.h"

#include <QComboBox>
#include <QDateTime>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <deque>

namespace hexoderm {

/// The lines of a log that are at least so severe and hold a text; follows the log.
class LogModel : public ColumnTable {
  Q_OBJECT

 public:
  /// `log` must outlive the model.
  explicit LogModel(const EventLog& log, QObject* parent = nullptr) : ColumnTable(parent), log_(log) {
    const auto column = [this](const QString& name, QString (*text)(const LogLine&)) {
      return Column{.name = name, .is_text = true, .value = [this, text](int row) { return text(lineAt(row)); }};
    };
    Column what = column(tr("What"), [](const LogLine& line) {
      return QString(line.text).replace(QLatin1Char('\n'), QLatin1Char(' '));
    });
    what.tool_tip = [this](int row) { return lineAt(row).text; };
    setColumns({column(tr("Time"),
                       [](const LogLine& line) {
                         return QDateTime::fromMSecsSinceEpoch(line.at_ms).toString(QStringLiteral("HH:mm:ss"));
                       }),
                column(tr("Severity"),
                       [](const LogLine& line) {
                         return QStringLiteral("%1 %2").arg(severitySign(line.severity), severityWord(line.severity));
                       }),
                what});
    connect(&log, &EventLog::grown, this, &LogModel::takeNew);
    takeNew();
  }

  void setFilter(Severity at_least, const QString& text) {
    beginResetModel();
    at_least_ = at_least;
    text_ = text;
    shown_.clear();
    taken_ = 0;
    endResetModel();
    takeNew();
  }

  [[nodiscard]] const LogLine& lineAt(int row) const { return shown_[static_cast<std::size_t>(row)]; }
  /// A sign beside the word, so that what matters is found at a glance and in both themes.
  static QString severitySign(Severity severity) {
    return ofEnum(severity, {QStringLiteral("·"), QStringLiteral("▲"), QStringLiteral("✕")});
  }

 protected:
  [[nodiscard]] int rows() const override { return static_cast<int>(shown_.size()); }

 private:
  void takeNew() {
    std::vector<LogLine> fresh = log_.linesAfter(taken_);
    if (fresh.empty()) return;
    taken_ = fresh.back().number;
    std::erase_if(fresh, [this](const LogLine& line) { return !isWanted(line); });
    if (fresh.empty()) return;
    const auto first = static_cast<int>(shown_.size());
    beginInsertRows({}, first, first + static_cast<int>(fresh.size()) - 1);
    std::move(fresh.begin(), fresh.end(), std::back_inserter(shown_));
    endInsertRows();
    if (shown_.size() > EventLog::kCapacity) {
      const std::size_t surplus = shown_.size() - EventLog::kCapacity;
      beginRemoveRows({}, 0, static_cast<int>(surplus) - 1);
      shown_.erase(shown_.begin(), shown_.begin() + static_cast<std::ptrdiff_t>(surplus));
      endRemoveRows();
    }
  }

  [[nodiscard]] bool isWanted(const LogLine& line) const {
    return line.severity >= at_least_ && (text_.isEmpty() || line.text.contains(text_, Qt::CaseInsensitive));
  }

  const EventLog& log_;
  Severity at_least_ = Severity::Info;
  QString text_;
  std::uint64_t taken_ = 0;  ///< number of the last line that was looked at
  std::deque<LogLine> shown_;
};

/// The log, to be searched and to be sent.
class LogView : public QWidget {
  Q_OBJECT

 public:
  /// `log` must outlive the view.
  explicit LogView(const EventLog& log, QWidget* parent = nullptr) : QWidget(parent), model_(new LogModel(log, this)) {
    setObjectName(QStringLiteral("logView"));
    severity_->addItems({tr("Everything"), tr("Warnings and errors"), tr("Errors")});
    text_->setPlaceholderText(tr("Search"));
    text_->setClearButtonEnabled(true);
    auto* copy = named(new QPushButton(tr("Copy for a bug report")), "logCopy");
    copy->setToolTip(
        tr("Copies versions, graphics, what is open and the last 200 lines; your home folder is left out"));
    auto* folder = named(new QPushButton(tr("Open folder")), "logFolder");
    folder->setToolTip(log.folder().isEmpty() ? tr("This log is not kept in a file") : log.filePath());
    folder->setEnabled(!log.folder().isEmpty());
    connect(copy, &QPushButton::clicked, this, &LogView::reportWanted);
    connect(folder, &QPushButton::clicked, this, &LogView::folderWanted);

    table_->setModel(model_);
    dressRows(table_);
    // All rows alike: measuring 10,000 of them would be felt.
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table_->horizontalHeader()->setStretchLastSection(true);
    fitColumns();

    // The bar has two rows where one is too narrow: it must not determine the width of the window.
    auto* bar = new FlowLayout;
    bar->setContentsMargins(12, 6, 12, 6);
    bar->setSpacing(8);
    addWidgets(bar, {severity_, text_});
    bar->beginSecondGroup();
    addWidgets(bar, {count_, copy, folder});
    auto* layout = spaced(new QVBoxLayout(this), {0, 0, 0, 0}, 0);
    layout->addLayout(bar);
    layout->addWidget(table_, 1);

    connect(severity_, qOverload<int>(&QComboBox::currentIndexChanged), this, &LogView::applyFilter);
    connect(text_, &QLineEdit::textChanged, this, &LogView::applyFilter);
    // The newest line stays in view for who is looking at it, and for nobody else.
    connect(model_, &QAbstractItemModel::rowsAboutToBeInserted, this, [this] {
      const QScrollBar* bar_of_table = table_->verticalScrollBar();
      const bool at_end = bar_of_table->value() >= bar_of_table->maximum() - 1;
      table_->setProperty("atEnd", at_end);
    });
    connect(model_, &QAbstractItemModel::rowsInserted, this, [this] {
      if (table_->property("atEnd").toBool()) table_->scrollToBottom();
      showCount();
    });
    connect(model_, &QAbstractItemModel::rowsRemoved, this, &LogView::showCount);
    connect(model_, &QAbstractItemModel::modelReset, this, &LogView::showCount);
    showCount();
  }

 signals:
  void reportWanted();
  void folderWanted();

 protected:
  void showEvent(QShowEvent* event) override {
    QWidget::showEvent(event);
    table_->scrollToBottom();
  }

  void changeEvent(QEvent* event) override {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fitColumns();
  }

 private:
  void fitColumns() {
    // From what is known to be in them: asking every line would be felt.
    const QFontMetrics metrics(table_->font());
    int severity = 0;
    for (const Severity each : {Severity::Info, Severity::Warning, Severity::Error}) {
      severity = std::max(
          severity, metrics.horizontalAdvance(LogModel::severitySign(each) + QLatin1Char(' ') + severityWord(each)));
    }
    const int margin = 3 * metrics.averageCharWidth() + 12;
    table_->setColumnWidth(0, metrics.horizontalAdvance(QStringLiteral("00:00:00")) + margin);
    table_->setColumnWidth(1, severity + margin);
  }

  void applyFilter() {
    model_->setFilter(static_cast<Severity>(severity_->currentIndex()), text_->text().trimmed());
    table_->scrollToBottom();
  }

  void showCount() {
    const int count = model_->rowCount();
    count_->setText(count == 1 ? tr("1 line") : tr("%1 lines").arg(locale().toString(count)));
  }

  LogModel* model_;
  QComboBox* severity_ = named(new QComboBox, "logSeverity", tr("Which lines of the log are shown"));
  QLineEdit* text_ = named(new QLineEdit, "logText", tr("Search the log"));
  QTableView* table_ = named(new QTableView, "logTable", tr("Log"));
  QLabel* count_ = styledAs(new QLabel, "muted");
};

}  // namespace hexoderm
