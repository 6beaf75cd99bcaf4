// Mark-up that is well-formed XML too, so that a test can read it.
#include "accuracy/page/document.h"

#include <algorithm>
#include <cctype>

#include "accuracy/page/controls.h"

namespace carom::tools::accuracy {
namespace {

using report::escape;

constexpr const char* kStyle = R"(
:root{color-scheme:light;--ground:#fcfcfa;--ink:#1f2328;--soft:#62666d;--line:#e4e4df;--panel:#f4f4f0;--bad:#c11f2e;
--badground:#fdecec;--accent:#1f66d0}
body{font:16px/1.55 system-ui,sans-serif;margin:0;background:var(--ground);color:var(--ink)}
main{max-width:57rem;margin:0 auto;padding:2.5rem 1.25rem 6rem}
h1{font-size:2.1rem;line-height:1.2;margin:0 0 .3rem}
h2{font-size:1.45rem;margin:3.5rem 0 .8rem;padding-top:.8rem;border-top:1px solid var(--line)}
h3{font-size:1.1rem;margin:2.2rem 0 .5rem}
.sub{color:var(--soft);margin:0 0 2rem}
p,li{max-width:46rem}li{margin:.35rem 0}
a{color:var(--accent)}
nav{background:var(--panel);border-radius:8px;padding:.9rem 1.2rem;margin:1.5rem 0;font-size:.93rem}
nav ul{margin:.3rem 0;padding-left:1.2rem;columns:2;column-gap:2.5rem}nav li{break-inside:avoid;margin:.15rem 0}
nav .sub3{list-style:none;margin-left:.2rem;color:var(--soft)}
figure{margin:1.4rem 0 2rem}figure svg{max-width:100%;height:auto;display:block}
figcaption{color:var(--soft);font-size:.9rem;max-width:46rem;margin-top:.3rem}
.scroll{overflow-x:auto}
table{border-collapse:collapse;margin:1rem 0;font-size:.88rem;font-variant-numeric:tabular-nums}
caption,summary{text-align:left;font-weight:600;padding-bottom:.4rem}summary{cursor:pointer;font-size:.9rem}
th,td{padding:.22rem .7rem;text-align:right;border-bottom:1px solid var(--line);vertical-align:top}
th{color:var(--soft);font-weight:600}
th:first-child,td:first-child,.words{text-align:left;padding-left:.3rem}
tr.bad td{background:var(--badground)}tr.bad td:first-child{border-left:3px solid var(--bad);color:var(--bad);font-weight:600}
.bad-word{color:var(--bad);font-weight:600}
#tip{position:fixed;pointer-events:none;background:var(--ink);color:var(--ground);font-size:.82rem;line-height:1.4;
padding:.35rem .6rem;border-radius:5px;opacity:0;transition:opacity .08s;white-space:pre;z-index:9}
)";

constexpr const char* kDarkStyle = R"(
:root{color-scheme:dark;--ground:#16181d;--ink:#e8e8e4;--soft:#a2a6ad;--line:#30343b;--panel:#1e2128;
--bad:#ff7079;--badground:#3a1d21;--accent:#74aaff}
)";
// Paper is light.
constexpr const char* kDarkWhen = "screen and (prefers-color-scheme: dark)";

}  // namespace

void Document::heading(int level, const std::string& id, const std::string& text) {
  const std::string h = "h" + std::to_string(level);
  body_ += "<" + h + " id=\"" + escape(id) + "\">" + escape(text) + "</" + h + ">\n";
  contents_ += std::string("<li") + (level == 3 ? " class=\"sub3\"" : "") + "><a href=\"#" + escape(id) + "\">" +
               escape(text) + "</a></li>\n";
}

void Document::paragraph(const std::string& text) { body_ += "<p>" + escape(text) + "</p>\n"; }

void Document::list(const std::vector<std::string>& items) {
  body_ += "<ul>\n";
  for (const std::string& item : items) body_ += "<li>" + escape(item) + "</li>\n";
  body_ += "</ul>\n";
}

void Document::figure(const std::string& id, const std::string& svg, const std::string& caption) {
  body_ += "<figure id=\"" + escape(id) + "\">\n" + svg + "<figcaption>" + escape(caption) + "</figcaption></figure>\n";
}

void Document::table(const std::string& title, const std::vector<std::string>& header,
                     const std::vector<std::vector<std::string>>& rows, bool folded, const std::vector<bool>& marked,
                     const std::string& id, const std::vector<std::string>& data) {
  if (folded) body_ += "<details><summary>" + escape(title) + "</summary>\n";
  body_ += "<div class=\"scroll\"><table" + (id.empty() ? "" : " id=\"" + escape(id) + "\"") + ">";
  if (!folded) body_ += "<caption>" + escape(title) + "</caption>";
  // Columns of words stand left, columns of numbers right.
  std::vector<std::string> look(header.size());
  for (const auto& row : rows)
    for (std::size_t c = 0; c < std::min(row.size(), look.size()); ++c)
      if (!row[c].empty() && !std::isdigit(static_cast<unsigned char>(row[c][0])) && row[c] != "-" && row[c] != "none")
        look[c] = " class=\"words\"";
  body_ += "\n<tr>";
  for (std::size_t c = 0; c < header.size(); ++c) body_ += "<th" + look[c] + ">" + escape(header[c]) + "</th>";
  body_ += "</tr>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    body_ += r < marked.size() && marked[r] ? "<tr class=\"bad\"" : "<tr";
    body_ += (r < data.size() ? data[r] : std::string()) + ">";
    for (std::size_t c = 0; c < header.size(); ++c)
      body_ += "<td" + look[c] + ">" + (c < rows[r].size() ? escape(rows[r][c]) : std::string()) + "</td>";
    body_ += "</tr>\n";
  }
  body_ += "</table></div>\n";
  if (folded) body_ += "</details>\n";
}

void Document::begin(const std::string& classes, const std::string& data) {
  body_ += "<div class=\"" + escape(classes) + "\"" + data + ">\n";
}

void Document::end() { body_ += "</div>\n"; }

void Document::controls(const std::vector<std::string>& engines, const std::vector<std::string>& settings,
                        const std::vector<std::string>& scenes) {
  body_ += controls_markup(engines, settings, scenes);
}

std::string Document::text() const {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\"/><title>" +
         escape(title_) + "</title>\n<style>" + report::light_style_sheet() + kStyle + controls_style() +
         "</style>\n<style id=\"dark\" media=\"" + kDarkWhen + "\">" + report::dark_style_sheet() + kDarkStyle +
         "</style></head><body><main>\n<h1>" + escape(title_) + "</h1>\n<p class=\"sub\">" + escape(subtitle_) +
         "</p>\n" + body_.substr(0, contents_at_) + "<nav aria-label=\"Contents\"><ul>\n" + contents_ +
         "</ul></nav>\n" + body_.substr(contents_at_) + "</main><div id=\"tip\"></div><script>" + controls_script() +
         "</script></body></html>\n";
}

}  // namespace carom::tools::accuracy
