#include "hexoderm/io/xml_writing.h"

#include <pugixml.hpp>
#include <sstream>
#include <utility>

namespace hexoderm {
namespace {

void appendAttributes(pugi::xml_node node, std::initializer_list<XmlAttribute> attributes) {
  for (const XmlAttribute& attribute : attributes) node.append_attribute(attribute.name) = attribute.value.c_str();
}

}  // namespace

pugi::xml_node appendElement(pugi::xml_node parent, const char* name, std::initializer_list<XmlAttribute> attributes) {
  pugi::xml_node node = parent.append_child(name);
  appendAttributes(node, attributes);
  return node;
}

void appendComment(pugi::xml_node parent, const std::string& text) {
  parent.append_child(pugi::node_comment).set_value(text.c_str());
}

void declareXml(pugi::xml_document& document) {
  appendAttributes(document.append_child(pugi::node_declaration), {{"version", "1.0"}, {"encoding", "UTF-8"}});
}

std::string xmlText(const pugi::xml_document& document, const char* indent) {
  std::ostringstream out;
  document.save(out, indent);
  return std::move(out).str();
}

}  // namespace hexoderm
