#include "hexoderm/reconstruction/result/quality_colors.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

TEST(QualityColors, DifferByClassAndBackground) {
  EXPECT_EQ(qualityColor(EdgeQuality::Undefined, Background::Light), 0x7F0D14U);
  EXPECT_EQ(qualityColor(EdgeQuality::Partially, Background::Light), 0xE66F15U);
  EXPECT_EQ(qualityColor(EdgeQuality::Fully, Background::Light), 0x17A1CAU);
  EXPECT_EQ(qualityColor(EdgeQuality::Over, Background::Light), 0x3A1FB0U);
  EXPECT_EQ(unusedColor(Background::Light), 0x8A939EU);
  EXPECT_EQ(qualityColor(EdgeQuality::Undefined, Background::Dark), 0xD64A45U);
  EXPECT_EQ(qualityColor(EdgeQuality::Partially, Background::Dark), 0xFFDE3EU);
  EXPECT_EQ(qualityColor(EdgeQuality::Fully, Background::Dark), 0x87F5FAU);
  EXPECT_EQ(qualityColor(EdgeQuality::Over, Background::Dark), 0x7A6BE8U);
  EXPECT_EQ(unusedColor(Background::Dark), 0x757F8BU);
}

}  // namespace
}  // namespace hexoderm
