#pragma once

class QAbstractSpinBox;

namespace hexoderm {

/// A field with a text for a special value ("not known") takes what is typed in place of that text. Qt's own would look
/// for a number in both together, find none, and ignore every key.
void letTypingReplaceSpecialText(QAbstractSpinBox* field);

}  // namespace hexoderm
