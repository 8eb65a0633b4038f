#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Stands in for TinyXML-2, which Debian does not offer for WebAssembly, with the part that descriptions of
/// FMUs use. A test compares the files with those of TinyXML-2.
namespace tinyxml2 {

class XMLPrinter {
public:
  void PushDeclaration(const char* text) { out_ += "<?" + std::string(text) + "?>"; }
  void OpenElement(const char* name) {
    end_tag();
    out_ += '\n' + std::string(4 * open_.size(), ' ') + '<' + name;
    open_.emplace_back(name);
    has_open_tag_ = true;
  }
  void PushAttribute(const char* name, const char* value) {
    out_ += ' ' + std::string(name) + "=\"" + escaped(value) + '"';
  }
  void CloseElement() {
    const std::string name = open_.back();
    open_.pop_back();
    if (has_open_tag_)
      out_ += "/>";
    else
      out_ += '\n' + std::string(4 * open_.size(), ' ') + "</" + name + '>';
    has_open_tag_ = false;
    if (open_.empty()) out_ += '\n';
  }
  const char* CStr() const { return out_.c_str(); }

private:
  void end_tag() {
    if (has_open_tag_) out_ += '>';
    has_open_tag_ = false;
  }
  static std::string escaped(std::string_view plain) {
    std::string out;
    for (const char c : plain) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&apos;"; break;
      default: out += c;
      }
    return out;
  }

  std::string out_{};
  std::vector<std::string> open_{};
  bool has_open_tag_ = false;
};

} // namespace tinyxml2
