#pragma once

#include <vector>

namespace hexoderm {

/// Of all of core's texts, in the files for Qt Linguist.
inline constexpr char kCoreWordsContext[] = "hexoderm::CoreWords";

/// The texts that core makes for people, with %1, %2, ... for what varies. Whoever changes such a text in core, or adds
/// one, does so here too; a test makes core say them and finds those without a template.
const std::vector<const char*>& coreTemplates();

}  // namespace hexoderm
