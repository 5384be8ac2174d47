#include "tests/core/io/placed_skin.h"
#include "tests/core/io/taxel_readers.h"

namespace hexoderm {
namespace {

using ExportTaxels = PlacedSkin;

TEST_F(ExportTaxels, OfIcubAreTheCellsInTheLinksFrame) {
  const auto taxels = test::readIcubTaxels(bytes(ExportFormat::Icub));
  ASSERT_TRUE(taxels);
  EXPECT_EQ(taxels->name, "forearm");
  ASSERT_EQ(taxels->rows.size(), 12U) << "one triangle";
  ASSERT_EQ(taxels->representatives.size(), taxels->rows.size());
  for (std::size_t row = 0; row < taxels->rows.size(); ++row) {
    const auto& found = taxels->rows[row];
    if (row >= 3) {
      EXPECT_FALSE(found.isTaxel()) << row;
      EXPECT_EQ(taxels->representatives[row], -1);
      continue;
    }
    EXPECT_EQ(taxels->representatives[row], static_cast<int>(row));
    const SE3 T_l_u = T_l_o_ * reconstruction_.patches[0].cells[row].T_o_u;
    EXPECT_LT((found.position - T_l_u.t).norm(), 1e-9);
    EXPECT_LT((found.normal - T_l_u.R.col(2)).norm(), 2e-9);
  }
}

TEST_F(ExportTaxels, OfIcubLoseNoCellToAReaderThatDropsTheLastLineOrRow) {
  for (const std::uint32_t columns : {1U, 4U, 6U}) {  // 2, 8 and 12 cells
    const Reconstruction sheet = sheetReconstruction(columns, 2);
    const std::string text = exportBytes(sheet, ExportFormat::Icub, {});
    const auto whole = test::readIcubTaxels(text);
    const auto dropped = test::readIcubTaxels(text, true);
    const auto dropped_row = test::readIcubTaxels(text.substr(0, text.size() - 1), true);
    ASSERT_TRUE(whole && dropped && dropped_row);
    const auto count = [](const test::IcubTaxels& taxels) {
      return static_cast<std::size_t>(
          std::ranges::count_if(taxels.rows, [](const auto& row) { return row.isTaxel(); }));
    };
    EXPECT_EQ(count(*whole), sheet.cellCount());
    EXPECT_EQ(count(*dropped), sheet.cellCount());
    EXPECT_EQ(count(*dropped_row), sheet.cellCount());
    EXPECT_EQ(whole->rows.size() % 12, 0U);
    EXPECT_EQ(dropped_row->rows.size(), whole->rows.size() - 1);
  }
}

TEST_F(ExportTaxels, OfIcubAreThoseOfOneLink) {
  options_.placements.push_back({CellId(20), "r_hand", {}, {}});
  EXPECT_THAT(messageOf<InvalidArgument>([&] { return bytes(ExportFormat::Icub); }), HasSubstr("in_link"));
  options_.in_link = "r_hand";
  const auto taxels = test::readIcubTaxels(bytes(ExportFormat::Icub));
  ASSERT_TRUE(taxels);
  EXPECT_EQ(taxels->name, "r_hand");
  EXPECT_EQ(taxels->representatives[0], 0);
  EXPECT_EQ(taxels->representatives[1], -1);
}

TEST_F(ExportTaxels, OfSkinwareAreNanometresAndNameTheLinkByNumber) {
  options_.placements.push_back({CellId(20), "r_hand", {}, {}});
  const auto cells = test::readSkinware(bytes(ExportFormat::Skinware));
  ASSERT_TRUE(cells);
  ASSERT_EQ(cells->size(), 4U);
  const CellPlacement& placement = reconstruction_.patches[0].cells[2];
  const SE3 T_l_u = T_l_o_ * placement.T_o_u;
  const auto& numbers = (*cells)[2].numbers;
  EXPECT_EQ(numbers[1], 12);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(static_cast<double>(numbers[static_cast<std::size_t>(2 + axis)]), 1e9 * T_l_u.t[axis], 0.6);
    EXPECT_NEAR(static_cast<double>(numbers[static_cast<std::size_t>(5 + axis)]), 1e9 * T_l_u.R(axis, 2), 0.6);
  }
  EXPECT_NEAR(static_cast<double>(numbers[8]), 1e9 * 0.01502 * std::sqrt(0.75), 0.6);
  EXPECT_EQ(numbers[9], 0);
  EXPECT_EQ((*cells)[3].numbers[1], 20);
  EXPECT_EQ((*cells)[3].numbers[9], 1);
}

}  // namespace
}  // namespace hexoderm
