// Whatever a session holds, the window says the same of it everywhere: banner, steps, actions and report follow from
// the one assessment. What that agrees with in core is checked by tests/core/solve/agreement_test.cpp.

#include "app/window/report/report.h"
#include "hexoderm/solve/metrics/assess.h"
#include "tests/app/window/window_test.h"
#include "tests/support/random_session.h"
#include "widgets/words/words.h"

#include <algorithm>
#include <array>

namespace hexoderm {
namespace {

class WindowAgreementTest : public WindowTest {
 protected:
  QString stateOf(int step) {
    return find<QWidget>(qPrintable(QStringLiteral("stepHead%1").arg(step)))->accessibleName();
  }
  QString noteOf(int step) {
    return find<QWidget>(qPrintable(QStringLiteral("stepHead%1").arg(step)))->accessibleDescription();
  }
  bool isDone(int step) { return stateOf(step).endsWith(QLatin1String(": done")); }
  bool isCurrent(int step) { return stateOf(step).endsWith(QLatin1String(": current")); }

  void expectAgreement() {
    const Reconstruction& result = *controller().reconstruction();
    const Assessment& a = result.assessment;
    const std::string reason = a.reason.english();

    EXPECT_EQ(find<QLabel>("bannerSentence")->text().toStdString(), reason);
    auto* button = find<QPushButton>("bannerButton");
    EXPECT_TRUE(button->isEnabled()) << "the best next action can be done: " << button->text().toStdString();
    const Finding* worst = worstFinding(result);

    // No skin is connected, so nothing can be retaken: what is of no use leads to a skin, and is not exported.
    EXPECT_FALSE(action("actionRetake")->isEnabled());
    const bool leads_to_export = button->text() == action("actionExport")->iconText();
    EXPECT_EQ(leads_to_export, a.isUsable() && !(worst && worst->severity == Severity::Error)) << reason;

    EXPECT_EQ(isDone(3), a.isUsable()) << "captured: " << reason;
    EXPECT_TRUE(isDone(3) || !isDone(4)) << "reviewed before it is captured: " << reason;
    EXPECT_EQ(isDone(4), a.isUsable() && worst == nullptr) << "reviewed: " << reason;
    EXPECT_EQ(isCurrent(7), isDone(4)) << "to be exported: " << reason;
    EXPECT_FALSE(isDone(5)) << "nobody has run a check";
    EXPECT_FALSE(isDone(6)) << "nobody has named a robot";
    EXPECT_EQ(noteOf(4).startsWith(QLatin1String("no findings")), result.findings.empty()) << noteOf(4).toStdString();

    expectTheReportSaysSo(result);
  }

  static void expectTheReportSaysSo(const Reconstruction& result) {
    ReportContent content;
    content.reconstruction = std::make_shared<const Reconstruction>(result);
    content.made_at = QDateTime(QDate(2026, 3, 4), QTime(5, 6, 7));
    const QString html = reportHtml(content);
    EXPECT_TRUE(html.contains(words(result.assessment.reason).toHtmlEscaped())) << result.assessment.reason;
    EXPECT_TRUE(html.contains(words(result.assessment.next_action).toHtmlEscaped())) << result.assessment.next_action;
    for (const Finding& finding : result.findings) {
      EXPECT_TRUE(html.contains(words(finding.message).toHtmlEscaped())) << finding.message;
    }
  }
};

TEST_F(WindowAgreementTest, OfBannerStepsActionsAndReportInRandomSessions) {
  constexpr std::uint64_t kSessions = 60;
  constexpr std::uint64_t kMostSessions = 300;
  std::array<std::size_t, 6> levels{};
  const auto isDone = [&](std::uint64_t seed) {
    return (seed > kSessions && std::ranges::count(levels, 0U) == 0) || seed > kMostSessions;
  };
  for (std::uint64_t seed = 1; !isDone(seed) && !HasFailure(); ++seed) {
    SCOPED_TRACE("session " + std::to_string(seed));
    // Seeds that agreement_test does not draw.
    const Session session = test::RandomSession(100'000 + seed).draw();
    ASSERT_NO_FATAL_FAILURE(openSession(QStringLiteral("random%1.session.json").arg(seed), session));
    ASSERT_NO_FATAL_FAILURE(expectAgreement());
    ++levels.at(static_cast<std::size_t>(controller().reconstruction()->assessment.level));
  }
  for (const std::size_t count : levels) EXPECT_GT(count, 0) << "every level was drawn";
}

}  // namespace
}  // namespace hexoderm
