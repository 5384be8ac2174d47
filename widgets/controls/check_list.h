#pragma once

#include "hexoderm/capture/skin_check.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/words/words.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

namespace hexoderm {

/// Results of checks of a skin, one line each with a sign and its words. A fault has a button that shows where it is.
class CheckList : public QWidget {
  Q_OBJECT

 public:
  explicit CheckList(QWidget* parent = nullptr) : QWidget(parent) {
    setObjectName(QStringLiteral("checkList"));
    spaced(layout_, {0, 0, 0, 0}, 6);
  }

  void setCheck(const SkinCheck& check) {
    while (rows_.size() < check.items.size()) {
      rows_.push_back(new Row(this));
      layout_->addWidget(rows_.back());
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      rows_[k]->setVisible(k < check.items.size());
      if (k < check.items.size()) rows_[k]->set(check.items[k]);
    }
  }

 signals:
  /// The operator wants to see where.
  void cellPicked(hexoderm::CellId cell);

 private:
  class Row : public QWidget {
   public:
    explicit Row(CheckList* list) : QWidget(list) {
      makeBold(sign_);
      setPlainParagraph(text_);
      show_->setText(CheckList::tr("Show"));
      auto* words = spaced(new QVBoxLayout, 4);
      words->addWidget(text_);
      words->addWidget(show_, 0, Qt::AlignLeft);
      auto* layout = spaced(new QHBoxLayout(this), {0, 0, 0, 0}, 8);
      layout->addWidget(sign_, 0, Qt::AlignTop);
      layout->addLayout(words, 1);
      connect(show_, &QPushButton::clicked, list, [this, list] { emit list->cellPicked(item_.cells.front()); });
    }

    void set(const SkinCheckItem& item) {
      item_ = item;
      text_->setText(words(item.message));
      const bool wrong = item.severity != Severity::Info;
      setTone(sign_, wrong ? Tone::Caution : Tone::Good);
      sign_->setText(wrong ? QStringLiteral("!") : QStringLiteral("✓"));
      sign_->setAccessibleName(wrong ? CheckList::tr("needs a look") : CheckList::tr("in order"));
      show_->setVisible(wrong && !item.cells.empty());
      show_->setAccessibleName(CheckList::tr("Show: %1").arg(text_->text()));
    }

   private:
    SkinCheckItem item_;
    QLabel* sign_ = new QLabel;
    QLabel* text_ = new QLabel;
    QPushButton* show_ = new QPushButton;
  };

  QVBoxLayout* layout_ = new QVBoxLayout(this);
  std::vector<Row*> rows_;
};

}  // namespace hexoderm
