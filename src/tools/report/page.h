// One HTML page that shows what a run of a report wrote: sentences, tables, and the drawings that lie beside it.
#pragma once

#include <string>
#include <vector>

namespace carom::report {

/// Rows of cells; a row shorter than the header is filled with empty cells. Numbers stand right, the first column left.
struct Table {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Collects sections and gives the document. It refers to drawings by file name, so page and drawings share a folder.
class Page {
 public:
  explicit Page(const std::string& title);
  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void table(const Table& table);
  void drawing(const std::string& file_name, const std::string& alternative_text);
  std::string document() const;

 private:
  std::string title_, body_;
};

}  // namespace carom::report
