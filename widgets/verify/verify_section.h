#pragma once

#include "widgets/verify/verify_words.h"

#include <QFrame>
#include <QLabel>
#include <QTableView>
#include <QTimer>
#include <QWidget>
#include <initializer_list>

class QHBoxLayout;

namespace hexoderm {

class Selection;
class SortedTable;
class CsvActions;

/// One check of a calibration: what it asks, its controls, its verdict in a sentence, and the figures behind it. A row
/// that is picked picks its cell or link.
class VerifySection : public QFrame {
  Q_OBJECT

 public:
  /// `name` is for objects inside of it and the file that its table is saved as.
  VerifySection(const QString& heading, const QString& question, const QString& name, Selection* selection);

  /// A new row of controls; with some, they stand at its left.
  QHBoxLayout* addRow(std::initializer_list<QWidget*> controls = {});
  void setSentence(const VerifySentence& sentence);
  /// No rows: no table.
  void setMetrics(VerifyMetrics figures);
  /// Says and shows nothing.
  void clear();
  /// Shows that it is being worked on, with a button to cancel that, once it takes longer than a blink.
  void setRunning(bool running);
  [[nodiscard]] bool isRunning() const { return running_; }
  [[nodiscard]] CsvActions* csvActions() const { return csv_actions_; }

 signals:
  void cancelled();
  /// The row of the figures as they were given; -1: none.
  void rowPicked(int row);

 private:
  void paintSentence();
  void pick(int row);

  Selection* selection_;
  QWidget* rows_ = new QWidget;
  QWidget* progress_ = new QWidget;
  QLabel* sign_ = new QLabel;
  QLabel* sentence_ = new QLabel;
  QTableView* view_ = new QTableView;
  ResultTable* table_;
  SortedTable* sorted_;
  CsvActions* csv_actions_;
  VerifySentence said_;
  bool running_ = false;
  QTimer patience_;
};

}  // namespace hexoderm
