#pragma once

#include "hexoderm/base/finding.h"

#include "app/window/log/event_log.h"
#include "widgets/tables/column_table.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QWidget>
#include <deque>

namespace hexoderm {

/// The lines of a log that are at least so severe and hold a text; follows the log.
class LogModel : public ColumnTable {
  Q_OBJECT

 public:
  /// `log` must outlive the model.
  explicit LogModel(const EventLog& log, QObject* parent = nullptr);

  void setFilter(Severity at_least, const QString& text);
  [[nodiscard]] const LogLine& lineAt(int row) const { return shown_[static_cast<std::size_t>(row)]; }

 protected:
  [[nodiscard]] int rows() const override { return static_cast<int>(shown_.size()); }

 private:
  void takeNew();
  [[nodiscard]] bool isWanted(const LogLine& line) const;

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
  explicit LogView(const EventLog& log, QWidget* parent = nullptr);

 signals:
  void reportWanted();
  void folderWanted();

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fitColumns();
  void applyFilter();
  void showCount();

  LogModel* model_;
  QComboBox* severity_ = new QComboBox;
  QLineEdit* text_ = new QLineEdit;
  QTableView* table_ = new QTableView;
  QLabel* count_ = new QLabel;
};

}  // namespace hexoderm
