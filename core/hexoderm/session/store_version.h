#pragma once

namespace hexoderm {

/// The newest version of a *.hexo, which is written; README.md in this folder says what each has.
inline constexpr int kStoreVersion = 5;

}  // namespace hexoderm
