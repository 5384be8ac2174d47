#include "widgets/controls/check_list.h"

#include "widgets/words/words.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace hexoderm {

class CheckList::Row : public QWidget {
 public:
  explicit Row(CheckList* list) : QWidget(list), sign_(new QLabel), text_(new QLabel), show_(new QPushButton) {
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    show_->setText(CheckList::tr("Show"));
    auto* words = new QVBoxLayout;
    words->setSpacing(4);
    words->addWidget(text_);
    words->addWidget(show_, 0, Qt::AlignLeft);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(sign_, 0, Qt::AlignTop);
    layout->addLayout(words, 1);
    connect(show_, &QPushButton::clicked, list, [this, list] { emit list->cellPicked(item_.cells.front()); });
  }

  void set(const SkinCheckItem& item) {
    item_ = item;
    text_->setText(words(item.message));
    const bool wrong = item.severity != Severity::Info;
    sign_->setText(wrong ? QStringLiteral("!") : QStringLiteral("✓"));
    sign_->setAccessibleName(wrong ? CheckList::tr("needs a look") : CheckList::tr("in order"));
    show_->setVisible(wrong && !item.cells.empty());
    show_->setAccessibleName(CheckList::tr("Show: %1").arg(text_->text()));
  }
  void setTheme(Theme theme) {
    const Colors& colors = Colors::of(theme);
    QFont bold = font();
    bold.setBold(true);
    sign_->setFont(bold);
    QPalette palette = sign_->palette();
    palette.setColor(QPalette::WindowText, item_.severity == Severity::Info ? colors.good : colors.caution);
    sign_->setPalette(palette);
  }

 private:
  SkinCheckItem item_;
  QLabel* sign_;
  QLabel* text_;
  QPushButton* show_;
};

CheckList::CheckList(QWidget* parent) : QWidget(parent), layout_(new QVBoxLayout(this)) {
  setObjectName(QStringLiteral("checkList"));
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(6);
}

void CheckList::setCheck(const SkinCheck& check) {
  while (rows_.size() < check.items.size()) {
    rows_.push_back(new Row(this));
    layout_->addWidget(rows_.back());
  }
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    rows_[k]->setVisible(k < check.items.size());
    if (k >= check.items.size()) continue;
    rows_[k]->set(check.items[k]);
    rows_[k]->setTheme(theme_);
  }
}

void CheckList::setTheme(Theme theme) {
  theme_ = theme;
  for (Row* row : rows_) row->setTheme(theme);
}

}  // namespace hexoderm
