// The page's mark-up and style.
#include "report/page.h"

#include "report/svg.h"

namespace carom::report {
namespace {

constexpr const char* kStyle =
    "body{font:16px/1.5 system-ui,sans-serif;max-width:50rem;margin:2rem auto;padding:0 1rem;"
    "background:#fcfcfa;color:#1f2328}img{max-width:100%;display:block;margin:1rem 0}"
    "table{border-collapse:collapse;margin:1rem 0}caption{text-align:left;font-weight:600;padding-bottom:.4rem}"
    "th,td{padding:.2rem .8rem;text-align:right;border-bottom:1px solid #8884}"
    "th:first-child,td:first-child{text-align:left;padding-left:0}"
    "@media(prefers-color-scheme:dark){body{background:#16181d;color:#e8e8e4}}";

}  // namespace

Page::Page(const std::string& title) : title_(title) {}

void Page::heading(const std::string& text) { body_ += "<h2>" + escape(text) + "</h2>\n"; }

void Page::paragraph(const std::string& text) { body_ += "<p>" + escape(text) + "</p>\n"; }

void Page::table(const Table& table) {
  body_ += "<table><caption>" + escape(table.title) + "</caption>\n<tr>";
  for (const auto& h : table.header) body_ += "<th>" + escape(h) + "</th>";
  body_ += "</tr>\n";
  for (const auto& row : table.rows) {
    body_ += "<tr>";
    for (std::size_t c = 0; c < table.header.size(); ++c)
      body_ += "<td>" + (c < row.size() ? escape(row[c]) : std::string()) + "</td>";
    body_ += "</tr>\n";
  }
  body_ += "</table>\n";
}

void Page::drawing(const std::string& file_name, const std::string& alternative_text) {
  body_ += "<img src=\"" + escape(file_name) + "\" alt=\"" + escape(alternative_text) + "\"/>\n";
}

std::string Page::document() const {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>" + escape(title_) +
         "</title><style>" + kStyle + "</style></head><body>\n<h1>" + escape(title_) + "</h1>\n" + body_ +
         "</body></html>\n";
}

}  // namespace carom::report
