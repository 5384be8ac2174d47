#pragma once

#include "app/window/report/report_blocks.h"

namespace hexoderm {

/// The report as one file for a browser, with all pictures in it and without scripts. Printed, it has its stamp and the
/// heads of its tables on every page, too.
QString htmlOf(const ReportDocument& document);

}  // namespace hexoderm
