#pragma once

#include "app/window/report/report.h"

#include <QDialog>

class QLineEdit;
class QPlainTextEdit;

namespace hexoderm {

/// A small form for what stands at the head of a report. It is not modal: the window can be looked at, and worked in,
/// while it is filled in.
class ReportTitleDialog : public QDialog {
  Q_OBJECT

 public:
  /// `session`: the name of what is open; `proceed`: what the button says.
  ReportTitleDialog(const ReportTitle& title, const QString& session, const QString& proceed,
                    QWidget* parent = nullptr);

  [[nodiscard]] ReportTitle title() const;

 private:
  QLineEdit* robot_;
  QLineEdit* part_;
  QLineEdit* operator_;
  QPlainTextEdit* notes_;
};

}  // namespace hexoderm
