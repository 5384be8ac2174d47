#pragma once

#include <QString>

class QWidget;

namespace hexoderm {

class EventLog;
class SessionController;

/// What somebody who looks for a bug asks first: versions, graphics, screen, what is open, and the last 200 lines of
/// the log. Holds no folder of the user's: the home folder is written as ~. In English, whatever the window speaks.
/// `window`: the main window, whose graphics are described.
QString composeBugReport(const EventLog& log, const SessionController& controller, QWidget& window);

/// The home folder and the user's name in it, wherever they occur, become ~.
QString withoutHome(QString text, const QString& home);

}  // namespace hexoderm
