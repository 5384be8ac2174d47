#pragma once

#include <QString>

class QWidget;

namespace hexoderm {

class EventLog;
class SessionController;

/// What somebody who looks for a bug asks first: versions, graphics, screen, what is open, and the last 200 lines of
/// the log, with the home folder written as ~. In English, whatever the window speaks.
/// `window`: the main window, whose graphics are described.
QString composeBugReport(const EventLog& log, const SessionController& controller, QWidget& window);

/// The home folder, and with it the user's name, becomes ~ wherever it occurs as a whole: of /home/me, not in
/// /home/me2.
QString withoutHome(QString text, const QString& home);

}  // namespace hexoderm
