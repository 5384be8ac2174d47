#pragma once

#include <QString>

class QWidget;

namespace hexoderm {

class EventLog;
class SessionController;

/// The facts that somebody who looks for a bug asks for first: versions, graphics, screen, open files, and the last 200
/// lines of the log, with the home folder written as ~. In English, whatever the language of the window. `window`: the
/// main window, whose graphics are described.
QString composeBugReport(const EventLog& log, const SessionController& controller, QWidget& window);

/// The home folder, and with it the user's name, becomes ~ wherever it occurs as a whole: of /home/me, not in
/// /home/me2.
QString withoutHome(QString text, const QString& home);

}  // namespace hexoderm
