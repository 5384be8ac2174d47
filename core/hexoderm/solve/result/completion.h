#pragma once

namespace hexoderm {

/// How a step that may take seconds ended: it did its work, or it left because stop was requested, and then what it was
/// to leave behind is not complete.
enum class Completion { Finished, Stopped };

}  // namespace hexoderm
