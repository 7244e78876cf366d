#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/model/find_hits.h"
#include "viz/debugger/panels/copying.h"
#include "viz/debugger/panels/panel.h"
#include "viz/debugger/panels/panel_menu.h"
#include "viz/debugger/session/recent_files.h"
#include "viz/draw/palette.h"

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

/// What a search finds beside `find_hits`: recordings to open, by their path or among the latest, changes of
/// the view to take back, and panels to copy.
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

constexpr std::size_t kMostHits = 12;      // rows that have room
constexpr std::size_t kMostQueries = 100;  // of the history

bool is_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

/// Up and Down choose a row; without a query they go through the history.
void move_choice(SearchMemory& search, std::size_t rows) {
  const int way = is_pressed(ImGuiKey_DownArrow) ? 1 : is_pressed(ImGuiKey_UpArrow) ? -1 : 0;
  if (way == 0 || rows == 0) return;
  search.chosen = (search.chosen + rows + static_cast<std::size_t>(way + static_cast<int>(rows))) % rows;
}

void remember_query(SearchMemory& search) {
  std::erase(search.history, search.text);
  search.history.insert(search.history.begin(), search.text);
  if (search.history.size() > kMostQueries) search.history.pop_back();
}

void follow_hit(PanelContext& context, const SearchHit& hit) {
  SearchMemory& search = context.memory.search;
  if (!search.text.empty()) remember_query(search);
  search.is_open = false;
  try {
    hit.go(context.model);
  } catch (const std::invalid_argument& error) {
    context.model.message = error.what();
    context.model.message_is_error = true;
  }
}

/// Things and moments first, then what can be done with the session, then with the window.
std::vector<SearchHit> all_hits(PanelContext& context, const std::string& query) {
  std::vector<SearchHit> hits = find_all_hits(context, query);
  std::vector<SearchHit> of_window = window_hits(context, query);
  std::ranges::move(of_window, std::back_inserter(hits));
  return hits;
}

/// Earlier queries come back by their first hit.
std::vector<SearchHit> hits_of_history(PanelContext& context) {
  std::vector<SearchHit> hits;
  for (const std::string& query : context.memory.search.history)
    if (std::vector<SearchHit> found = all_hits(context, query); !found.empty())
      hits.push_back({query, "searched before", std::move(found.front().go)});
  return hits;
}

/// As much of a long text as a row has room for: of a path its end.
std::string ending_of(const std::string& text) {
  constexpr std::size_t kMost = 48;
  return text.size() <= kMost ? text : "..." + text.substr(text.size() - kMost + 3);
}

void draw_hits(PanelContext& context, const std::vector<SearchHit>& hits) {
  SearchMemory& search = context.memory.search;
  const std::size_t first = search.chosen < kMostHits ? 0 : search.chosen - kMostHits + 1;
  for (std::size_t k = first; k < std::min(hits.size(), first + kMostHits); ++k) {
    const std::string text = ending_of(hits[k].text);
    if (widgets::row(context.gui, text, "hit " + std::to_string(k), k == search.chosen))
      return follow_hit(context, hits[k]);
    ImGui::SameLine(std::max(280.0F, ImGui::CalcTextSize(text.c_str()).x + 20));
    ImGui::TextDisabled("%s", widgets::elided(hits[k].note, ImGui::GetContentRegionAvail().x).c_str());
  }
  if (hits.empty()) ImGui::TextDisabled("nothing of that name here");
  if (hits.size() > kMostHits) ImGui::TextDisabled("%zu in all", hits.size());
}

}  // namespace

void draw_search(PanelContext& context) {
  SearchMemory& search = context.memory.search;
  if (!search.is_open) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 64}, ImGuiCond_Always, {0.5F, 0});
  ImGui::SetNextWindowSize({480, 0});
  constexpr auto kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoSavedSettings;
  ImGui::SetNextWindowFocus();
  if (ImGui::Begin("search", nullptr, kFlags)) {
    std::vector<SearchHit> hits = all_hits(context, search.text);
    if (search.text.empty()) {
      std::vector<SearchHit> earlier = hits_of_history(context);
      earlier.insert(earlier.end(), hits.begin(), hits.end());
      hits = std::move(earlier);
    }
    move_choice(search, hits.size());
    search.chosen = std::min(search.chosen, hits.empty() ? 0 : hits.size() - 1);
    const std::string before = search.text;
    if (is_pressed(ImGuiKey_Tab) && !hits.empty()) {
      search.text = hits[search.chosen].text;
      ++search.completions;  // a new field: one that has the keys keeps its own text
      search.begins = true;
    }
    ImGui::PushID(search.completions);
    if (std::exchange(search.begins, false)) ImGui::SetKeyboardFocusHere();
    const bool entered =
        widgets::text_field(context.gui, "search text", search.text,
                            "node, object, pair, event, step, condition, query, command", -1);
    widgets::go_on_typing();
    ImGui::PopID();
    if (search.text != before) search.chosen = 0;
    draw_hits(context, hits);
    if (is_pressed(ImGuiKey_Escape)) search.is_open = false;
    if (entered && !hits.empty() && search.is_open) follow_hit(context, hits[search.chosen]);
  }
  ImGui::End();
}

}  // namespace kerf
