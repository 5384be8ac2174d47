#pragma once

#include "app/window/report/report.h"

namespace hexoderm {

// What the operator said about a session for its reports, kept in the settings, for the newest sessions. `session`: the
// path of its file, or its name where it has none.

/// Nothing, if it was not asked for yet.
std::optional<ReportTitle> keptReportTitle(const QString& session);
void keepReportTitle(const QString& session, const ReportTitle& title);

/// For a session that nothing was said about: robot and operator as they were last.
ReportTitle proposedReportTitle();

}  // namespace hexoderm
