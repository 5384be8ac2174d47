#pragma once

#include "app/window/presenters/presenter.h"

#include <memory>

namespace hexoderm {

class FilePresenter;
class ResultPresenter;
class ReviewPresenter;
class ThemePresenter;
class Verification;

// Wires of one duty each, in a source each. All they are given outlives the connections, `parts` too.

void connectVerify(const WindowParts& parts, Verification& verification, FilePresenter& files);
void connectPlot(const WindowParts& parts);
void connectGuide(const WindowParts& parts);
void connectHistory(const WindowParts& parts, FilePresenter& files);
void connectPreferences(const WindowParts& parts, ThemePresenter& themes);
void connectSpeech(const WindowParts& parts);
void connectLog(const WindowParts& parts);
void connectHelp(const WindowParts& parts);
/// Connects the commands that change how something is seen, which nothing but views know.
void connectViewCommands(const WindowParts& parts);

// Show what has changed, as Presenter::refresh().

void refreshGuide(const WindowParts& parts);
void refreshSpeech(const WindowParts& parts);
void refreshStatus(const WindowParts& parts);
void refreshHistory(const WindowParts& parts);

// The presenters with a state of their own that nothing else speaks to.

[[nodiscard]] std::unique_ptr<Presenter> makeCapturePresenter(const WindowParts& parts, const ResultPresenter& results);
[[nodiscard]] std::unique_ptr<Presenter> makeColoringPresenter(const WindowParts& parts,
                                                               const ResultPresenter& results);
[[nodiscard]] std::unique_ptr<Presenter> makePickedCommands(const WindowParts& parts, const ReviewPresenter& review);
[[nodiscard]] std::unique_ptr<Presenter> makeFindingPresenter(const WindowParts& parts, const ResultPresenter& results,
                                                              ReviewPresenter& review);
[[nodiscard]] std::unique_ptr<Presenter> makeExportPresenter(const WindowParts& parts, const Verification& verification,
                                                             FilePresenter& files);
[[nodiscard]] std::unique_ptr<Presenter> makeComparePresenter(const WindowParts& parts,
                                                              const Verification& verification);
[[nodiscard]] std::unique_ptr<Presenter> makeMarkPresenter(const WindowParts& parts);

}  // namespace hexoderm
