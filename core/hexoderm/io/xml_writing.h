#pragma once

// XML by pugixml.

#include <initializer_list>
#include <string>

namespace pugi {
class xml_document;
class xml_node;
}  // namespace pugi

namespace hexoderm {

struct XmlAttribute {
  const char* name;
  std::string value;
};

/// A new last element of `parent`, its attributes in this order.
pugi::xml_node appendElement(pugi::xml_node parent, const char* name,
                             std::initializer_list<XmlAttribute> attributes = {});
void appendComment(pugi::xml_node parent, const std::string& text);
/// Version 1.0 in UTF-8.
void declareXml(pugi::xml_document& document);
/// The whole file.
std::string xmlText(const pugi::xml_document& document, const char* indent);

}  // namespace hexoderm
