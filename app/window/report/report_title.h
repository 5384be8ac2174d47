#pragma once

#include "app/window/report/report.h"
#include "app/window/toolkit/dialogs.h"
#include "widgets/controls/panel_parts.h"

#include <QCryptographicHash>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSettings>
#include <QVBoxLayout>

namespace hexoderm {

inline constexpr int kMaxTitles = 200;

inline const QString kReportTitleOrder = QStringLiteral("report/order");
inline const QString kLastRobot = QStringLiteral("report/last_robot");
inline const QString kLastOperator = QStringLiteral("report/last_operator");

/// Paths have slashes, which would be folders of the settings.
inline QString reportTitleKey(const QString& session) {
  return QString::fromLatin1(QCryptographicHash::hash(session.toUtf8(), QCryptographicHash::Sha1).toHex());
}

inline QString reportTitleGroup(const QString& key) {
  return QStringLiteral("report/titles/") + key + QLatin1Char('/');
}

// What the operator said about a session for its reports, kept in the settings, for the newest sessions. `session`: the
// path of its file, or its name where it has none.

/// Nothing, if it was not asked for yet.
inline std::optional<ReportTitle> keptReportTitle(const QString& session) {
  const QSettings settings;
  const QString group = reportTitleGroup(reportTitleKey(session));
  if (!settings.contains(group + QStringLiteral("robot"))) return std::nullopt;
  const auto read = [&](const char* name) { return settings.value(group + QLatin1String(name)).toString(); };
  return ReportTitle{read("robot"), read("part"), read("operator"), read("notes")};
}
inline void keepReportTitle(const QString& session, const ReportTitle& title) {
  QSettings settings;
  const QString key = reportTitleKey(session);
  const QString group = reportTitleGroup(key);
  settings.setValue(group + QStringLiteral("robot"), title.robot);
  settings.setValue(group + QStringLiteral("part"), title.part);
  settings.setValue(group + QStringLiteral("operator"), title.made_by);
  settings.setValue(group + QStringLiteral("notes"), title.notes);
  settings.setValue(kLastRobot, title.robot);
  settings.setValue(kLastOperator, title.made_by);
  QStringList order = settings.value(kReportTitleOrder).toStringList();
  order.removeAll(key);
  order.prepend(key);
  while (order.size() > kMaxTitles) settings.remove(QStringLiteral("report/titles/") + order.takeLast());
  settings.setValue(kReportTitleOrder, order);
}

/// For a session that nothing was said about: robot and operator as they were last.
inline ReportTitle proposedReportTitle() {
  const QSettings settings;
  ReportTitle title;
  title.robot = settings.value(kLastRobot).toString();
  title.made_by = settings.value(kLastOperator).toString();
  return title;
}

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
    addPrimaryButton(this, buttons, proceed, "reportTitleButton");
    auto* layout = spaced(new QVBoxLayout(this), {20, 18, 20, 16}, 12);
    addWidgets(layout, {headline, remark});
    layout->addLayout(form);
    layout->addWidget(buttons);
    resize(460, sizeHint().height());
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
