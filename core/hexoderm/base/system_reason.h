#pragma once

#include "hexoderm/base/message.h"

#include <system_error>

namespace hexoderm {

/// The system's own words for an error number (`errno`), as a message where people meet it often, else verbatim.
Message systemReason(int error_number);
/// The same for an error code of any category.
Message systemReason(const std::error_code& error);

}  // namespace hexoderm
