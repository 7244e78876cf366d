#include "viz/debugger/panels/session_hits.h"

#include <algorithm>
#include <iterator>

#include "viz/debugger/panels/copying.h"
#include "viz/debugger/session/recent_files.h"

namespace kerf {
namespace {

constexpr std::string_view kOpen = "open ";

/// A folder goes on being typed, a file is opened.
SearchHit opening(PanelMemory& memory, const std::string& path) {
  const bool is_folder = path.ends_with('/');
  const std::string text = std::string(kOpen) + path;
  if (!is_folder)
    return {text, path.ends_with(".kerf") ? "recording" : "file",
            [&memory, path](DebuggerModel&) { memory.session.open = path_of(path); }};
  return {text, "folder", [&memory, text](DebuggerModel&) {
            open_search(memory.search);
            memory.search.text = text;
            ++memory.search.completions;
          }};
}

/// What completes the path that is being typed, then the latest recordings of which it is part; these come
/// first as long as nothing is typed.
std::vector<SearchHit> paths(PanelMemory& memory, const std::string& typed) {
  std::vector<SearchHit> hits;
  std::vector<std::string> all = complete_path(typed);
  const auto latest = typed.empty() ? all.begin() : all.end();
  all.insert(latest, memory.session.recent.begin(), memory.session.recent.end());
  for (const std::string& path : all)
    if (has_all_words(path, typed)) hits.push_back(opening(memory, path));
  if (hits.empty()) hits.push_back(opening(memory, typed));
  return hits;
}

}  // namespace

std::vector<SearchHit> find_all_hits(const PanelContext& context, const std::string& query) {
  PanelMemory& memory = context.memory;
  if (query.starts_with(kOpen)) return paths(memory, query.substr(kOpen.size()));
  std::vector<SearchHit> hits = find_hits(context.model, query);
  const auto add = [&](SearchHit hit) {
    if (has_all_words(hit.text, query)) hits.push_back(std::move(hit));
  };
  add({"open a recording", "Ctrl+O", [&memory](DebuggerModel&) {
         open_search(memory.search);
         memory.search.text = kOpen;
         ++memory.search.completions;
       }});
  add({"undo a change of the view", "Ctrl+Z",
       [&memory](DebuggerModel&) { memory.session.changes_back = 1; }});
  add({"redo a change of the view", "Ctrl+Y",
       [&memory](DebuggerModel&) { memory.session.changes_back = -1; }});
  for (const CopiedPanel& panel : kCopiedPanels) {
    const auto copy = [&](bool as_csv) {
      add({"copy " + std::string(panel.name) + (as_csv ? " as CSV" : ""), "into the clipboard",
           [&memory, panel, as_csv](DebuggerModel&) {
             memory.session.copy = CopyWish{std::string(panel.name), as_csv};
           }});
    };
    copy(false);
    if (panel.is_table) copy(true);
  }
  for (const std::string& recent : memory.session.recent) {
    SearchHit hit = opening(memory, recent);
    hit.note = "opened lately";
    add(std::move(hit));
  }
  return hits;
}

}  // namespace kerf
