#pragma once

#include "app/window/report/report.h"

namespace hexoderm {

/// The pictures that only views can draw: the skin graph, and the directions of gravity that were seen, for paper (the
/// light colours, whatever the window has), without anything that is there to be pressed. On the GUI thread. The
/// patches are drawn with the report itself.
std::vector<ReportPicture> takeReportPictures(const std::shared_ptr<const Reconstruction>& reconstruction);

}  // namespace hexoderm
