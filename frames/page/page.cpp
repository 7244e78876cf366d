#include "frames/page/page.h"

#include <array>
#include <cstdio>

namespace kerf {
namespace {

constexpr std::string_view kStyle = R"(
body{margin:0 auto;max-width:1120px;padding:1.5rem;font:16px/1.5 system-ui,sans-serif;color:#191919;background:#fafaf7}
h1{margin-bottom:.2rem}h2{margin-top:3rem;border-bottom:2px solid #0072b2;padding-bottom:.2rem}h3{margin-top:2rem}
nav a{margin-right:1rem;white-space:nowrap}.sub{color:#555}
figure{margin:1rem 0;background:#fff;border:1px solid #e0e0da;padding:.5rem;overflow-x:auto}
figure.wide{overflow:visible}figure svg{display:block;max-width:100%;height:auto}figcaption{color:#555;font-size:.9rem}
.scroll{overflow-x:auto}table{border-collapse:collapse;font-size:.8rem;margin:.5rem 0;white-space:nowrap}
th,td{padding:.2rem .5rem;text-align:right;vertical-align:top;border-bottom:1px solid #e4e4de}
th{position:sticky;top:0;background:#eeeee9}th:first-child,td:first-child{text-align:left}
tr.front td{background:#e3f1fa}tr.front td:first-child::before{content:"\25CB\00A0";font-weight:bold}
details{margin:.5rem 0 1.5rem}summary{cursor:pointer;color:#0072b2}
th.text,td.text{white-space:normal;text-align:left;min-width:6rem}tr:target td{background:#fff3c4}
.legend{position:sticky;top:0;z-index:1;background:#fff;padding:.3rem 0;border-bottom:1px solid #e0e0da}
.legend span{margin-right:1.2rem;white-space:nowrap}.legend svg{display:inline;vertical-align:middle;margin-right:.3rem}
.panels{display:grid;grid-template-columns:1fr 1fr;gap:.4rem}.panels svg{width:100%}
.values .strip{fill:transparent}.values rect.paper{fill:#fff;fill-opacity:.95;stroke:#999}.values path{stroke:#999}
.values text{font:11px system-ui,sans-serif}.values path,.values text,.values rect.paper{visibility:hidden;pointer-events:none}
.values g:hover>path,.values g:hover>text,.values g:hover>rect.paper{visibility:visible}
code{background:#eeeee9;padding:.1rem .3rem;border-radius:3px;font-size:.85rem}p.command{color:#555;font-size:.9rem}
)";

std::string value_text(const Json& value, const TableColumn& column) {
  if (value.is_string()) return escaped(value.get<std::string>());
  if (!value.is_number()) return "";
  std::array<char, 64> text{};
  const double number = value.get<double>() * column.scale;
  if (column.digits == kShortestDigits) {
    std::snprintf(text.data(), text.size(), "%.3g", number);
  } else {
    std::snprintf(text.data(), text.size(), "%.*f", column.digits, number);
  }
  return text.data();
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

Page::Page(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void Page::section(std::string_view id, std::string_view title) {
  contents_ += "<a href=\"#" + escaped(id) + "\">" + escaped(title) + "</a>\n";
  body_ += "<h2 id=\"" + escaped(id) + "\">" + escaped(title) + "</h2>\n";
}

void Page::heading(std::string_view title) { body_ += "<h3>" + escaped(title) + "</h3>\n"; }

void Page::paragraph(std::string_view text) { body_ += "<p>" + escaped(text) + "</p>\n"; }

void Page::figure(const std::string& svg, std::string_view caption) {
  body_ += "<figure>\n" + svg + "\n<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

void Page::figure_of_panels(const std::vector<LegendEntry>& legend, const std::vector<std::string>& svgs,
                            std::string_view caption) {
  body_ += "<figure class=\"wide\">\n<div class=\"legend\">";
  for (const LegendEntry& entry : legend) body_ += "<span>" + entry.svg + escaped(entry.name) + "</span>";
  body_ += "</div>\n<div class=\"panels\">\n";
  for (const std::string& svg : svgs) body_ += svg + "\n";
  body_ += "</div>\n<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

void Page::table(std::string_view summary, const std::vector<TableColumn>& columns, const Json& rows,
                 const std::vector<bool>& marked, bool open) {
  body_ += std::string("<details") + (open ? " open" : "") + "><summary>" + escaped(summary) +
           "</summary><div class=\"scroll\"><table>\n<tr>";
  for (const TableColumn& column : columns)
    body_ += (column.wraps ? "<th class=\"text\">" : "<th>") + escaped(column.title) + "</th>";
  body_ += "</tr>\n";
  for (std::size_t k = 0; k < rows.size(); ++k) row(columns, rows[k], k < marked.size() && marked[k]);
  body_ += "</table></div></details>\n";
}

void Page::row(const std::vector<TableColumn>& columns, const Json& row, bool marked) {
  const std::string id =
      row.contains(kRowId) ? " id=\"" + escaped(row[kRowId].get<std::string>()) + "\"" : "";
  body_ += "<tr" + id + (marked ? " class=\"front\">" : ">");
  for (const TableColumn& column : columns)
    body_ += (column.wraps ? "<td class=\"text\">" : "<td>") +
             (row.contains(column.key) ? value_text(row[column.key], column) : "") + "</td>";
  body_ += "</tr>\n";
}

void Page::command(std::string_view command) {
  body_ += "<p class=\"command\">Made by <code>" + escaped(command) + "</code></p>\n";
}

std::string Page::html() const {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width\">\n<link rel=\"icon\" href=\"data:,\">\n<title>" +
         escaped(title_) + "</title>\n<style>" + std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>" +
         escaped(title_) + "</h1>\n<p class=\"sub\">" + escaped(subtitle_) + "</p>\n<nav>" + contents_ +
         "</nav>\n" + body_ + "</body>\n</html>\n";
}

}  // namespace kerf
