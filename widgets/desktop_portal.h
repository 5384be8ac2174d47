#pragma once

#include "widgets/palette.h"

#include <optional>

namespace hexoderm {

/// The colour scheme that the desktop asks for through org.freedesktop.portal.Settings. Absent where there is no
/// session bus, no portal, no preference, no answer within a quarter of a second, or no QtDBus to ask with.
std::optional<Theme> desktopPortalTheme();

}  // namespace hexoderm
