#pragma once

class QWidget;

namespace hexoderm {

class WindowActions;

/// The list of keys, made from the actions themselves. Does not stop anybody from working on.
void showKeysDialog(QWidget* parent, const WindowActions& actions);

}  // namespace hexoderm
