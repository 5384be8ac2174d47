#pragma once

#include "hexoderm/base/finding.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

namespace hexoderm {

class FlowLayout;

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
  explicit FindingCard(QWidget* parent = nullptr);

  void setFinding(const Finding& finding, const std::vector<FindingOffer>& offers);
  [[nodiscard]] const Finding& finding() const { return finding_; }
  void setUnfolded(bool unfolded);
  [[nodiscard]] bool isUnfolded() const;

 signals:
  void showWanted(const hexoderm::Finding& finding);
  void remedyWanted(const hexoderm::Finding& finding, hexoderm::FindingRemedy remedy);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void setOffers(const std::vector<FindingOffer>& offers);

  Finding finding_;
  std::vector<FindingOffer> offers_;
  QLabel* severity_ = new QLabel(this);
  QLabel* what_;
  QLabel* where_;
  QPushButton* show_;
  QToolButton* fold_;
  QWidget* details_ = new QWidget(this);
  QLabel* why_;
  QLabel* todo_;
  QWidget* buttons_;
  FlowLayout* button_layout_;
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

  explicit FindingCards(const QString& object_name, QWidget* parent = nullptr);

  void setItems(const std::vector<Item>& items);
  [[nodiscard]] const std::vector<FindingCard*>& cards() const { return cards_; }

 signals:
  void showWanted(const hexoderm::Finding& finding);
  void remedyWanted(const hexoderm::Finding& finding, hexoderm::FindingRemedy remedy);
  /// The others are wanted, too.
  void allWanted();

 private:
  QVBoxLayout* layout_ = new QVBoxLayout(this);
  std::vector<FindingCard*> cards_;
  QPushButton* others_ = new QPushButton(this);
  std::vector<Item> items_;
  std::vector<Finding> shown_;
};

}  // namespace hexoderm
