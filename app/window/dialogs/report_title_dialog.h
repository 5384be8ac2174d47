#pragma once

#include "app/window/report/report.h"
#include "app/window/toolkit/file_dialog.h"
#include "widgets/controls/panel_parts.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace hexoderm {

/// A small form for what stands at the head of a report. It is not modal: the window can be looked at, and worked in,
/// while it is filled in.
class ReportTitleDialog : public QDialog {
  Q_OBJECT

 public:
  /// `session`: the name of what is open; `proceed`: what the button says.
  ReportTitleDialog(const ReportTitle& title, const QString& session, const QString& proceed, QWidget* parent = nullptr)
      : QDialog(parent),
        robot_(titleField("reportRobot", title.robot, tr("Robot"))),
        part_(titleField("reportPart", title.part, tr("Part"))),
        operator_(titleField("reportOperator", title.made_by, tr("Operator"))),
        notes_(new QPlainTextEdit(title.notes)) {
    setObjectName(QStringLiteral("reportTitleDialog"));
    setWindowTitle(tr("Title of the report"));
    auto* headline = styledAs(new QLabel(tr("What is the report about?"), this), "headline");
    auto* remark =
        new QLabel(tr("Stands at the head of every report on %1, and is remembered for it. Empty fields are left "
                      "out.")
                       .arg(session),
                   this);
    setPlainParagraph(remark);
    remark->setProperty("muted", true);
    robot_->setPlaceholderText(tr("its name or serial number"));
    part_->setPlaceholderText(tr("the body part that wears the skin"));
    setNames(notes_, QStringLiteral("reportNotes"), tr("Notes"));
    notes_->setTabChangesFocus(true);
    notes_->setFixedHeight(kNoteLines * notes_->fontMetrics().lineSpacing() + 14);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    form->addRow(tr("&Robot"), robot_);
    form->addRow(tr("&Part"), part_);
    form->addRow(tr("&Operator"), operator_);
    form->addRow(tr("&Notes"), notes_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    addPrimaryButton(buttons, proceed, "reportTitleButton");
    auto* layout = spaced(new QVBoxLayout(this), {20, 18, 20, 16}, 12);
    addWidgets(layout, {headline, remark});
    layout->addLayout(form);
    layout->addWidget(buttons);
    resize(460, sizeHint().height());
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    robot_->setFocus();
  }

  [[nodiscard]] ReportTitle title() const {
    return {robot_->text().trimmed(), part_->text().trimmed(), operator_->text().trimmed(),
            notes_->toPlainText().trimmed()};
  }

 private:
  static constexpr int kNoteLines = 4;
  static QLineEdit* titleField(const char* object_name, const QString& text, const QString& accessible_name) {
    auto* edit = new QLineEdit(text);
    setNames(edit, QLatin1String(object_name), accessible_name);
    return edit;
  }

  QLineEdit* robot_;
  QLineEdit* part_;
  QLineEdit* operator_;
  QPlainTextEdit* notes_;
};

}  // namespace hexoderm
