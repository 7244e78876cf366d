#include "tests/house/svg.h"

namespace kerf::house {
namespace {

std::string attribute(std::string_view name, int value) {
  return ' ' + std::string(name) + "=\"" + std::to_string(value) + '"';
}

std::string to_string(Point point) { return std::to_string(point.x) + ' ' + std::to_string(point.y); }

std::string escaped(std::string_view words) {
  std::string out;
  for (const char c : words) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else if (c != '`')  // Markdown's mark of code
      out += c;
  }
  return out;
}

}  // namespace

Svg::Svg(int width, int height)
    : body_(
          "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
          attribute("height", height) + " font-family=\"DejaVu Sans, sans-serif\" font-size=\"12\">\n" +
          "<defs><marker id=\"head\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"7\" "
          "markerHeight=\"7\" orient=\"auto\"><path d=\"M0 0 L8 4 L0 8 z\" fill=\"#555\"/></marker></defs>\n"
          "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n") {}

void Svg::box(Point corner, int width, int height, std::string_view fill, std::string_view stroke) {
  body_ += "<rect" + attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", width) +
           attribute("height", height) + " rx=\"5\" fill=\"" + std::string(fill) + "\" stroke=\"" +
           std::string(stroke) + "\"/>\n";
}

void Svg::text(Point at, std::string_view words, std::string_view style) {
  body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + ' ' + std::string(style) + '>' +
           escaped(words) + "</text>\n";
}

void Svg::arrow(Point from, Point to) {
  body_ += "<path d=\"M" + to_string(from) + " L" + to_string(to) +
           " \" fill=\"none\" stroke=\"#555\" stroke-width=\"1.3\" marker-end=\"url(#head)\"/>\n";
}

void Svg::arc(Point from, Point to, int bulge) {
  body_ += "<path d=\"M" + to_string(from) + " C" + to_string({from.x - bulge, from.y}) + ' ' +
           to_string({to.x - bulge, to.y}) + ' ' + to_string(to) +
           "\" fill=\"none\" stroke=\"#555\" stroke-width=\"1.1\" marker-end=\"url(#head)\"/>\n";
}

}  // namespace kerf::house
