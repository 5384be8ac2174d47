#pragma once

#include "app/window/presenters/presenter.h"

#include <memory>

namespace hexoderm {

class FilePresenter;
class ResultPresenter;
class ReviewPresenter;
class ThemePresenter;
class Verification;

// The presenters that nothing else speaks to. Each stands in a source of its own; all they are given outlives them.

[[nodiscard]] std::unique_ptr<Presenter> makeCapturePresenter(const WindowParts& parts, const ResultPresenter& results);
[[nodiscard]] std::unique_ptr<Presenter> makeColoringPresenter(const WindowParts& parts,
                                                               const ResultPresenter& results);
[[nodiscard]] std::unique_ptr<Presenter> makePickedCommands(const WindowParts& parts, const ReviewPresenter& review);
[[nodiscard]] std::unique_ptr<Presenter> makeFindingPresenter(const WindowParts& parts, const ResultPresenter& results,
                                                              ReviewPresenter& review);
[[nodiscard]] std::unique_ptr<Presenter> makeVerifyPresenter(const WindowParts& parts, Verification& verification,
                                                             FilePresenter& files);
[[nodiscard]] std::unique_ptr<Presenter> makeExportPresenter(const WindowParts& parts, const Verification& verification,
                                                             FilePresenter& files);
[[nodiscard]] std::unique_ptr<Presenter> makeComparePresenter(const WindowParts& parts,
                                                              const Verification& verification);
[[nodiscard]] std::unique_ptr<Presenter> makePlotPresenter(const WindowParts& parts);
[[nodiscard]] std::unique_ptr<Presenter> makeMarkPresenter(const WindowParts& parts);
[[nodiscard]] std::unique_ptr<Presenter> makeGuidePresenter(const WindowParts& parts);
[[nodiscard]] std::unique_ptr<Presenter> makeStatusPresenter(const WindowParts& parts);
[[nodiscard]] std::unique_ptr<Presenter> makeHistoryPresenter(const WindowParts& parts, FilePresenter& files);
[[nodiscard]] std::unique_ptr<Presenter> makePreferencesPresenter(const WindowParts& parts, ThemePresenter& themes);
[[nodiscard]] std::unique_ptr<Presenter> makeSpeechPresenter(const WindowParts& parts);
[[nodiscard]] std::unique_ptr<Presenter> makeLogPresenter(const WindowParts& parts);
[[nodiscard]] std::unique_ptr<Presenter> makeHelpPresenter(const WindowParts& parts);
/// Connects the commands that change how something is seen, which nothing but views know.
void connectViewCommands(const WindowParts& parts);

}  // namespace hexoderm
