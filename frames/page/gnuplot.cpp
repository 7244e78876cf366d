#include "frames/page/gnuplot.h"

#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "core/base/number_text.h"
#include "core/files/temporary_folder.h"

namespace kerf {
namespace {

/// A temporary file that goes away with the object.
class ScratchFile {
 public:
  ScratchFile() : name_((temporary_folder() / "kerf_plot_XXXXXX").string()) {
    const int file = mkstemp(name_.data());
    if (file < 0) throw std::runtime_error("cannot make the temporary file " + name_);
    close(file);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() { std::remove(name_.c_str()); }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::string text() const {
    std::ifstream stream(name_);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  std::string name_;
};

void replace_all(std::string& text, std::string_view from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

/// Browsers show titles under the pointer; gnuplot's are its commands.
void drop_titles(std::string& svg) {
  constexpr std::string_view kEndOfTitle = "</title>";
  for (std::size_t begin = 0; (begin = svg.find("<title>", begin)) != std::string::npos;)
    svg.erase(begin, svg.find(kEndOfTitle, begin) + kEndOfTitle.size() - begin);
}

/// The SVG without what precedes its element, and with ids that are unique to the picture.
std::string as_element(std::string svg, const std::string& id) {
  const std::size_t begin = svg.find("<svg");
  if (begin == std::string::npos || svg.find("</svg>") == std::string::npos)
    throw std::runtime_error("gnuplot drew nothing; try it in a terminal");
  svg.erase(0, begin);
  drop_titles(svg);
  for (const char* quote : {"'", "\""}) {
    replace_all(svg, std::string("id=") + quote, std::string("id=") + quote + id + "-");
    replace_all(svg, std::string("href=") + quote + "#", std::string("href=") + quote + "#" + id + "-");
  }
  replace_all(svg, "url(#", "url(#" + id + "-");
  return svg;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string plot_number(double x) { return exact_number(x); }

void require_gnuplot() {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0)
    throw std::runtime_error("there is no gnuplot, which draws the plots: apt-get install gnuplot-nox");
}

bool feed_gnuplot(const std::string& script) {
  std::FILE* const gnuplot = popen("gnuplot 2>/dev/null", "w");
  if (gnuplot == nullptr) throw std::runtime_error("no process for gnuplot");
  const bool written = std::fwrite(script.data(), 1, script.size(), gnuplot) == script.size();
  return pclose(gnuplot) == 0 && written;
}

std::string run_gnuplot(const std::string& script, int width, int height, std::string_view id) {
  const ScratchFile picture;
  const std::string head = "set encoding utf8\nset terminal svg noenhanced size " + std::to_string(width) +
                           "," + std::to_string(height) +
                           " font 'sans-serif,13' background 'white'\nset output " +
                           in_quotes(picture.name()) + "\n";
  if (!feed_gnuplot(head + script + "\nset output\n"))
    throw std::runtime_error("gnuplot did not draw the plot " + std::string(id));
  return as_element(picture.text(), std::string(id));
}

}  // namespace kerf
