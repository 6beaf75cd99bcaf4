// One HTML file that needs nothing beside it: mark-up, style and script of a report.
#pragma once

#include <string>
#include <vector>

#include "report/svg.h"

namespace carom::tools::accuracy {

/// Collects sections; the contents are made from their headings.
class Document {
 public:
  explicit Document(std::string title, std::string subtitle)
      : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

  /// @param id  of its anchor   @param level  2 or 3
  void heading(int level, const std::string& id, const std::string& text);
  void paragraph(const std::string& text);  ///< plain text
  void list(const std::vector<std::string>& items);
  /// @param svg  an SVG element   @param caption  how to read it
  void figure(const std::string& id, const std::string& svg, const std::string& caption);
  /// @param folded  shown when asked for   @param marked  rows that are shown as warnings
  /// @param id  of the table, or ""   @param data  of each row: more attributes, as mark-up, each after a space
  void table(const std::string& title, const std::vector<std::string>& header,
             const std::vector<std::vector<std::string>>& rows, bool folded = false,
             const std::vector<bool>& marked = {}, const std::string& id = "",
             const std::vector<std::string>& data = {});
  /// What follows, until end(), belongs together.   @param data  attributes, as for rows
  void begin(const std::string& classes, const std::string& data = "");
  void end();
  /// Filters, the order, the budget, the look: what page/controls.cpp has for these.
  void controls(const std::vector<std::string>& engines, const std::vector<std::string>& settings,
                const std::vector<std::string>& scenes);
  /// The contents stand here; default: before everything.
  void contents_here() { contents_at_ = body_.size(); }

  std::string text() const;

 private:
  std::string title_, subtitle_, contents_, body_;
  std::size_t contents_at_ = 0;
};

}  // namespace carom::tools::accuracy
