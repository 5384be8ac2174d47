#pragma once

#include "hexoderm/base/message.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hexoderm {

/// The one of `known` that somebody most likely meant by `name`, which is none of them: a slip of a letter or two,
/// another case, underscores left out, or a part of it ("time" for "time_us"). nullopt if none is near. Looks at the
/// first 100 characters.
std::optional<std::string> spellingSuggestion(std::string_view name, std::span<const std::string> known);
/// "did you mean NAME?"; says nothing if none is near.
Message didYouMean(std::string_view name, std::span<const std::string> known);

}  // namespace hexoderm
