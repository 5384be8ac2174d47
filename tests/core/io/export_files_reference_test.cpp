// Our files beside real ones of the tools that read them (HEXODERM_REFERENCE_DATA).

#include "hexoderm/io/exporter.h"
#include "hexoderm/io/tum_xml.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/core/io/taxel_readers.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/paths.h"

#include <cctype>
#include <pugixml.hpp>

namespace hexoderm {
namespace {

const std::filesystem::path kReal = std::filesystem::path(HEXODERM_REFERENCE_DATA) / "real";
using ExportedReference = ExportTest;

/// What XML holds but for its values: every path of elements with its attributes, and whether its text is a number, and
/// with how many decimals.
void collectStructure(pugi::xml_node node, const std::string& path, std::set<std::string>& found) {
  std::string entry = path + "/" + node.name();
  for (const pugi::xml_attribute attribute : node.attributes()) entry += std::string(" @") + attribute.name();
  const std::string text = node.text().get();
  const std::size_t point = text.find('.');
  if (!node.first_element_by_path("*") && !text.empty() &&
      text.find_first_not_of("-0123456789.") == std::string::npos) {
    entry += " number with " + std::to_string(point == std::string::npos ? 0 : text.size() - point - 1) + " decimals";
  }
  found.insert(entry);
  for (const pugi::xml_node child : node.children()) {
    if (child.type() == pugi::node_element) collectStructure(child, path + "/" + node.name(), found);
  }
}

std::set<std::string> structureOf(const std::string& text) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype));
  std::set<std::string> found;
  for (const pugi::xml_node node : document.children()) {
    if (node.type() == pugi::node_doctype) found.insert(std::string("doctype ") + node.value());
  }
  collectStructure(document.document_element(), "", found);
  return found;
}

TEST_F(ExportedReference, TumSkinConfigHasTheStructureOfARealOne) {
  const auto calibration = calibrationFromTum(readTumXml(kReal / "tum_skin_config.xml"), builtInCellModel("hex-bma150"),
                                              "tum_skin_config.xml");
  const std::string ours = exportBytes(*calibration, ExportFormat::Tum, {});
  EXPECT_EQ(structureOf(ours), structureOf(readFile(kReal / "tum_skin_config.xml")));
}

TEST_F(ExportedReference, ARealTaxelFileIsReadByTheReaderOfOurs) {
  const auto real = test::readIcubTaxels(readFile(kReal / "icub_left_forearm_V2.txt"));
  ASSERT_TRUE(real);
  EXPECT_EQ(real->name, "l_forearm");
  EXPECT_EQ(real->rows.size(), 384U);
  EXPECT_EQ(real->representatives.size(), 384U);
  for (std::size_t row = 0; row < real->rows.size(); ++row) {
    if (real->representatives[row] >= 0) {
      EXPECT_TRUE(real->rows[row].isTaxel()) << row;
    }
  }
  const std::string ours = exportBytes(makeTestReconstruction(), ExportFormat::Icub, {});
  const auto head = [](const std::string& text) {
    std::vector<std::string> keys;
    std::istringstream in(text);
    std::string line;
    for (int k = 0; k < 4 && std::getline(in, line); ++k) keys.push_back(line.substr(0, line.find_first_of(" \t")));
    return keys;
  };
  EXPECT_EQ(head(ours), head(readFile(kReal / "icub_left_forearm_V2.txt")));
  EXPECT_TRUE(readFile(kReal / "icub_left_forearm_V2.txt").ends_with("\n\n"));
  EXPECT_TRUE(ours.ends_with("\n\n"));
}

}  // namespace
}  // namespace hexoderm
