// A small judge of XML: is a document well-formed, and what attributes do its elements carry? Enough for our drawings.
#pragma once

#include <cctype>
#include <map>
#include <string>
#include <vector>

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< characters between its tags, entities as written
};

class XmlCheck {
 public:
  explicit XmlCheck(const std::string& document) : s_(document) { well_formed_ = parse(); }
  bool well_formed() const { return well_formed_; }
  const std::vector<Element>& elements() const { return elements_; }
  std::vector<Element> with_class(const std::string& name, const std::string& classes) const {
    std::vector<Element> out;
    for (const Element& e : elements_)
      if (e.name == name && e.attributes.count("class") && e.attributes.at("class") == classes) out.push_back(e);
    return out;
  }

 private:
  static bool is_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == ':';
  }
  std::string name() {
    std::string out;
    while (i_ < s_.size() && is_name(s_[i_])) out += s_[i_++];
    return out;
  }
  void blanks() {
    while (i_ < s_.size() && std::isspace(static_cast<unsigned char>(s_[i_]))) ++i_;
  }
  // At '&': one of the five entities, or a decimal reference.
  bool entity() const {
    const std::size_t end = s_.find(';', i_);
    if (end == std::string::npos) return false;
    const std::string e = s_.substr(i_ + 1, end - i_ - 1);
    return e == "amp" || e == "lt" || e == "gt" || e == "quot" || e == "apos" || (e.size() > 1 && e[0] == '#');
  }
  bool attributes(Element& e) {
    for (blanks(); i_ < s_.size() && is_name(s_[i_]); blanks()) {
      const std::string key = name();
      if (i_ + 1 >= s_.size() || s_[i_] != '=' || s_[i_ + 1] != '"') return false;
      std::string value;
      for (i_ += 2; i_ < s_.size() && s_[i_] != '"'; ++i_) {
        if (s_[i_] == '<' || (s_[i_] == '&' && !entity())) return false;
        value += s_[i_];
      }
      if (i_++ >= s_.size() || !e.attributes.emplace(key, value).second) return false;
    }
    return true;
  }
  bool tag(std::vector<std::size_t>& open) {
    if (s_.compare(i_, 2, "</") == 0) {
      i_ += 2;
      const std::string closing = name();
      if (open.empty() || elements_[open.back()].name != closing || i_ >= s_.size() || s_[i_++] != '>') return false;
      open.pop_back();
      return true;
    }
    ++i_;
    Element e;
    e.name = name();
    if (e.name.empty() || !attributes(e)) return false;
    const bool empty = s_.compare(i_, 2, "/>") == 0;
    if (!empty && (i_ >= s_.size() || s_[i_] != '>')) return false;
    i_ += empty ? 2 : 1;
    elements_.push_back(e);
    if (!empty) open.push_back(elements_.size() - 1);
    return true;
  }
  bool parse() {
    if (s_.compare(0, 15, "<!DOCTYPE html>") == 0) i_ = 15;
    std::vector<std::size_t> open;
    bool seen_root = false;
    while (i_ < s_.size()) {
      if (s_[i_] == '<') {
        if (open.empty() && seen_root) return false;
        if (!tag(open)) return false;
        seen_root = true;
      } else {
        if (s_[i_] == '>' || (s_[i_] == '&' && !entity())) return false;
        if (open.empty() && !std::isspace(static_cast<unsigned char>(s_[i_]))) return false;
        if (!open.empty()) elements_[open.back()].text += s_[i_];
        ++i_;
      }
    }
    return seen_root && open.empty();
  }

  std::string s_;
  std::size_t i_ = 0;
  std::vector<Element> elements_;
  bool well_formed_ = false;
};
