#include "app/window/presenters/presenters.h"

#include "app/window/log/bug_report.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QGuiApplication>
#include <QUrl>

namespace hexoderm {

void connectLog(const WindowParts& parts) {
  EventLog& log = parts.log;
  MessageBar* const messages = parts.views.messages;
  const auto copyReport = [&parts, messages] {
    QGuiApplication::clipboard()->setText(composeBugReport(parts.log, parts.controller, parts.window));
    messages->showMessage(Tone::Good,
                          WindowParts::tr("Copied: versions, graphics, what is open and the last lines of the log, "
                                          "with your home folder as ~. Paste it into the report."));
  };
  const auto openFolder = [&log, messages] {
    if (QDesktopServices::openUrl(QUrl::fromLocalFile(log.folder()))) return;
    messages->showMessage(Tone::Caution, WindowParts::tr("No program to show folders was found. The log is %1.")
                                             .arg(QDir::toNativeSeparators(log.filePath())));
  };
  QObject::connect(parts.views.log, &LogView::reportWanted, &parts.wires, copyReport);
  QObject::connect(parts.views.log, &LogView::folderWanted, &parts.wires, openFolder);
  QObject::connect(parts.actions.copy_report, &QAction::triggered, &parts.wires, copyReport);
  QObject::connect(parts.actions.open_log_folder, &QAction::triggered, &parts.wires, openFolder);
  QObject::connect(&log, &EventLog::fileFailed, &parts.wires, [messages](const QString& why) {
    messages->showMessage(Tone::Caution, WindowParts::tr("The log is kept in memory only. %1").arg(why));
  });
}

}  // namespace hexoderm
