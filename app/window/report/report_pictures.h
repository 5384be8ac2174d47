#pragma once

#include "app/window/report/report.h"

namespace hexoderm {

/// The patch from three sides, the skin graph and the directions of gravity that were seen, drawn for paper (the light
/// colours, whatever the window has), in views of their own, so that what the operator looks at does not turn. On the
/// GUI thread. Without OpenGL the patch's pictures are left out.
std::vector<ReportPicture> takeReportPictures(const std::shared_ptr<const Reconstruction>& reconstruction);

}  // namespace hexoderm
