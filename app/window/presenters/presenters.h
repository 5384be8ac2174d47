#pragma once

#include "app/window/presenters/presenter.h"

namespace hexoderm {

class FilePresenter;
class ThemePresenter;
class Verification;

// Wires of one duty each, in a source each. All they are given outlives the connections, `parts` too.

void connectVerify(const WindowParts& parts, Verification& verification, FilePresenter& files);
void connectGuide(const WindowParts& parts);
void connectHistory(const WindowParts& parts, FilePresenter& files);
void connectPreferences(const WindowParts& parts, ThemePresenter& themes);
void connectHelp(const WindowParts& parts);
/// Connects the commands that change how something is seen, which nothing but views know.
void connectViewCommands(const WindowParts& parts);

// Show what has changed, once a turn of the event loop at most. The actions know already which of them can be used.

void refreshGuide(const WindowParts& parts);
void refreshStatus(const WindowParts& parts);
void refreshHistory(const WindowParts& parts);

}  // namespace hexoderm
