#pragma once

#include "hexoderm/base/finding.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QString>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <string>
#include <vector>

namespace hexoderm {

/// What can be done about a finding just now, in words for a button.
struct FindingOffer {
  FindingRemedy remedy{};
  QString text;
  friend bool operator==(const FindingOffer&, const FindingOffer&) = default;
};

/// A finding as a card: what was found and how bad it is; where, with a button that shows it; why the program thinks
/// so; and what to do, with a button for each thing that can be done from here. The reasons can be folded away.
class FindingCard : public QFrame {
  Q_OBJECT

 public:
  explicit FindingCard(QWidget* parent = nullptr) : QFrame(parent) {
    setObjectName(QStringLiteral("findingCard"));
    setProperty("card", true);
    makeBold(severity_);
    fold_->setCheckable(true);
    fold_->setToolButtonStyle(Qt::ToolButtonTextOnly);
    fold_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);  // as high as the button beside it
    // A copy: what follows may bring another finding here.
    connect(show_, &QPushButton::clicked, this, [this] { emit showWanted(Finding(finding_)); });
    connect(fold_, &QToolButton::toggled, this, &FindingCard::setUnfolded);

    auto* head = spaced(new QHBoxLayout, 6);
    head->addWidget(severity_);
    head->addWidget(where_, 1);
    auto* actions = spaced(new QHBoxLayout, 6);
    addWidgets(actions, {show_, fold_});
    actions->addStretch(1);
    auto* details = spaced(new QVBoxLayout(details_), {0, 2, 0, 0}, 6);
    addWidgets(details, {why_, todo_, buttons_});
    auto* layout = spaced(new QVBoxLayout(this), {14, 9, 10, 10}, 6);
    layout->addLayout(head);
    layout->addWidget(what_);
    layout->addLayout(actions);
    layout->addWidget(details_);
    setUnfolded(false);
  }

  void setFinding(const Finding& finding, const std::vector<FindingOffer>& offers) {
    finding_ = finding;
    const FindingDescription& description = descriptionOf(finding.code);
    severity_->setText(severityWord(finding.severity));
    setTone(severity_, toneOf(finding.severity));
    what_->setText(unbroken(words(finding.message)));
    const bool is_somewhere = !finding.cells.empty() || !finding.poses.empty();
    where_->setText(is_somewhere ? placeText(finding) : QString());
    show_->setVisible(is_somewhere);
    show_->setAccessibleName(tr("Show: %1").arg(what_->text()));
    why_->setText(tr("Why: %1").arg(words(description.why)));
    todo_->setText(tr("What to do: %1").arg(words(description.what_to_do)));
    setOffers(offers);
    update();
  }

  [[nodiscard]] const Finding& finding() const { return finding_; }

  void setUnfolded(bool unfolded) {
    fold_->setChecked(unfolded);
    fold_->setText(unfolded ? tr("Less ▴") : tr("Why, and what to do ▾"));
    fold_->setAccessibleName(unfolded ? tr("Fold the reasons away") : tr("Why, and what to do"));
    details_->setVisible(unfolded);
    updateGeometry();
  }

  [[nodiscard]] bool isUnfolded() const { return !details_->isHidden(); }

 signals:
  void showWanted(const hexoderm::Finding& finding);
  void remedyWanted(const hexoderm::Finding& finding, hexoderm::FindingRemedy remedy);

 protected:
  /// A stripe on the left in the colour of the severity, which the word says too.
  void paintEvent(QPaintEvent* event) override {
    QFrame::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(toneColor(toneOf(finding_.severity), themeOf(palette())));
    painter.drawRoundedRect(QRectF(4.5, 8.5, 3, height() - 17), 1.5, 1.5);
  }

 private:
  void setOffers(const std::vector<FindingOffer>& offers) {
    buttons_->setVisible(!offers.empty());
    if (offers == offers_) return;
    offers_ = offers;
    while (QLayoutItem* item = button_layout_->takeAt(0)) {
      item->widget()->hide();
      item->widget()->deleteLater();  // it may be the one that was pressed
      delete item;
    }
    for (const FindingOffer& offer : offers) {
      const std::string name = "findingRemedy" + std::to_string(static_cast<int>(offer.remedy));
      auto* button = quiet(new QPushButton(offer.text, buttons_), name.c_str());
      connect(button, &QPushButton::clicked, this,
              [this, remedy = offer.remedy] { emit remedyWanted(Finding(finding_), remedy); });
      button_layout_->addWidget(button);
      button->show();
    }
  }

  Finding finding_;
  std::vector<FindingOffer> offers_;
  QLabel* severity_ = named(new QLabel(this), "findingSeverity");
  QLabel* what_ = paragraph("findingWhat", this);
  QLabel* where_ = styledAs(paragraph("findingWhere", this), "muted");
  QPushButton* show_ = quiet(new QPushButton(tr("Show"), this), "findingShow");
  QToolButton* fold_ = styledAs(quiet(new QToolButton(this), "findingFold"), "flat");
  QWidget* details_ = new QWidget(this);
  QLabel* why_ = paragraph("findingWhy", details_);
  QLabel* todo_ = paragraph("findingToDo", details_);
  QWidget* buttons_ = new QWidget(details_);
  FlowLayout* button_layout_ = spaced(new FlowLayout(buttons_), {0, 0, 0, 0}, 6);
};

/// Cards of several findings, one below the other; the first is unfolded. Of many only the first few, and the number of
/// the others.
class FindingCards : public QWidget {
  Q_OBJECT

 public:
  struct Item {
    Finding finding;
    std::vector<FindingOffer> offers;
    friend bool operator==(const Item&, const Item&) = default;
  };

  explicit FindingCards(const QString& object_name, QWidget* parent = nullptr) : QWidget(parent) {
    setObjectName(object_name);
    spaced(layout_, {0, 0, 0, 0}, 8);
    others_->setFocusPolicy(Qt::TabFocus);
    others_->hide();
    connect(others_, &QPushButton::clicked, this, &FindingCards::allWanted);
    layout_->addWidget(others_, 0, Qt::AlignLeft);
    hide();
  }

  void setItems(const std::vector<Item>& items) {
    constexpr std::size_t kMax = 4;
    if (items == items_) return;
    items_ = items;
    const std::size_t count = std::min(kMax, items.size());
    while (cards_.size() < count) {
      auto* card = new FindingCard(this);
      connect(card, &FindingCard::showWanted, this, &FindingCards::showWanted);
      connect(card, &FindingCard::remedyWanted, this, &FindingCards::remedyWanted);
      layout_->insertWidget(static_cast<int>(cards_.size()), card);
      cards_.push_back(card);
    }
    std::vector<Finding> shown;
    for (std::size_t k = 0; k < count; ++k) shown.push_back(items[k].finding);
    // Somebody may be reading: what is unfolded stays so, as long as the findings are the same.
    const bool are_others = shown != shown_;
    shown_ = std::move(shown);
    for (std::size_t k = 0; k < cards_.size(); ++k) {
      cards_[k]->setVisible(k < count);
      if (k >= count) continue;
      cards_[k]->setFinding(items[k].finding, items[k].offers);
      if (are_others) cards_[k]->setUnfolded(k == 0);
    }
    others_->setText(tr("%1 more under Findings").arg(items.size() - count));
    others_->setVisible(items.size() > count);
    setVisible(!items.empty());
  }

  [[nodiscard]] const std::vector<FindingCard*>& cards() const { return cards_; }

 signals:
  void showWanted(const hexoderm::Finding& finding);
  void remedyWanted(const hexoderm::Finding& finding, hexoderm::FindingRemedy remedy);
  /// The others are wanted, too.
  void allWanted();

 private:
  QVBoxLayout* layout_ = new QVBoxLayout(this);
  std::vector<FindingCard*> cards_;
  QPushButton* others_ = styledAs(new QPushButton(this), "flat");
  std::vector<Item> items_;
  std::vector<Finding> shown_;
};

}  // namespace hexoderm
