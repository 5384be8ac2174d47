#pragma once

#include "widgets/style/palette.h"

#include <QAbstractItemModel>
#include <QApplication>
#include <QBrush>
#include <string>
#include <vector>

namespace hexoderm::test {

/// What a cell of a table says in a role.
inline std::string text(const QAbstractItemModel& model, int row, int column, int role = Qt::DisplayRole) {
  return model.index(row, column).data(role).toString().toStdString();
}

inline std::vector<std::string> rowTexts(const QAbstractItemModel& model, int row) {
  std::vector<std::string> texts;
  for (int column = 0; column < model.columnCount(); ++column) texts.push_back(text(model, row, column));
  return texts;
}

inline std::vector<std::string> headers(const QAbstractItemModel& model) {
  std::vector<std::string> texts;
  for (int column = 0; column < model.columnCount(); ++column) {
    texts.push_back(model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().toStdString());
  }
  return texts;
}

/// The row is drawn as one that is not used.
inline bool isGrey(const QAbstractItemModel& model, int row) {
  return model.index(row, 0).data(Qt::ForegroundRole).value<QBrush>() ==
         QBrush(QApplication::palette().color(QPalette::PlaceholderText));
}

}  // namespace hexoderm::test
