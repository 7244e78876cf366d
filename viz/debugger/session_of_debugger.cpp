#include <stdexcept>
#include <utility>

#include "viz/debugger/debugger.h"
#include "viz/debugger/session/session_text.h"

namespace kerf {
namespace {

constexpr double kSavePause = 10;  // seconds

std::filesystem::path full_name(const std::filesystem::path& file) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(file));
}

}  // namespace

std::string Debugger::title() const {
  const std::string name = is_scratch() ? "" : " " + recording_.filename().string();
  return model_.run().info().scene + " - kerf debug" + name;
}

bool Debugger::is_scratch() const {
  std::error_code error;
  const auto folder = std::filesystem::absolute(recording_, error).parent_path();
  return std::filesystem::equivalent(folder, model_.work_folder, error);
}

void Debugger::keep_sessions_beside() {
  keeps_beside_ = true;
  if (keeper_.file().empty()) begin_session();
}

/// Of the recording that has just been opened.
void Debugger::begin_session() {
  offered_.reset();
  keeper_ = keeps_beside_ && !is_scratch() ? SessionKeeper(session_path(recording_)) : SessionKeeper();
  try {
    offered_ = keeper_.read();
  } catch (const std::runtime_error& error) {
    report(error.what(), true);
  }
  if (!offered_) return;
  memory_.session.offer = to_text(*offered_, model_.run().names());
  if (!is_of(offered_->recording, model_.run()))
    memory_.session.offer_warning =
        "It was made for another recording of this name: what it names may lie elsewhere, or not be there.";
}

void Debugger::go_on_with(const DebuggerSession& session) {
  std::string said = "went on at " + to_text(session, model_.run().names());
  const bool is_ours = is_of(session.recording, model_.run());
  if (!is_ours) said += "; it was made for another recording";
  const std::string left_out = go_on(session, model_);
  view_->set_camera(session.camera);
  if (!left_out.empty()) said += "; this recording does not have: " + left_out;
  report(said, !is_ours || !left_out.empty());
}

void Debugger::go_on_with_files(const std::vector<std::filesystem::path>& files) {
  if (files.empty()) return;
  std::optional<DebuggerSession> joined;
  const auto add = [&](const DebuggerSession& session) {
    joined = joined ? join(std::move(*joined), session) : session;
  };
  const bool is_one = files.size() == 1;
  if (!is_one)
    for (const auto& file : files) add(read_session_file(file));
  keeper_ = is_one         ? SessionKeeper(files.front())
            : is_scratch() ? SessionKeeper()
                           : SessionKeeper(session_path(recording_));
  const std::optional<DebuggerSession> kept = keeper_.read();
  if (kept) add(*kept);
  if (joined) go_on_with(*joined);
  if (kept) spare(keeper_, *kept);
}

void Debugger::load_session(const std::filesystem::path& file) {
  const DebuggerSession before = present_session();
  go_on_with(read_session_file(file));
  if (!keeper_.file().empty() && full_name(keeper_.file()) == full_name(file)) return;
  savers_.erase(full_name(file));
  (void)saver_of(file);
  if (!holds(present_session(), before)) keeper_.begin_anew();
}

std::string Debugger::save_session(const std::filesystem::path& file) {
  SessionKeeper& saver = saver_of(file);
  DebuggerSession session = present_session();
  if (&saver == &keeper_ && offered_) session = join(std::move(session), *offered_);
  std::string problem = saver.save(session);
  say_note(saver);
  return problem;
}

/// Of a file that was not gone on with, and that does not lose what only it has. Throws SessionError if it is
/// no session.
SessionKeeper& Debugger::saver_of(const std::filesystem::path& file) {
  const std::filesystem::path name = full_name(file);
  if (!keeper_.file().empty() && full_name(keeper_.file()) == name) {
    if (keeper_.is_foreign()) (void)keeper_.read();
    return keeper_;
  }
  const auto known = savers_.find(name);
  if (known != savers_.end()) return known->second;
  SessionKeeper saver(file);
  if (const auto kept = saver.read()) spare(saver, *kept);
  return savers_.emplace(name, std::move(saver)).first->second;
}

/// What is in the file gets another name before it is replaced, unless all of it has come into view.
void Debugger::spare(SessionKeeper& keeper, const DebuggerSession& kept) {
  const bool is_all_there = is_of(kept.recording, model_.run()) && holds(present_session(), kept);
  if (!is_all_there && has_anything(kept)) keeper.begin_anew();
}

void Debugger::say_note(SessionKeeper& keeper) {
  const std::string note = keeper.take_note();
  if (note.empty()) return;
  report(note, false);
  if (say_earlier_) say_earlier_(note);
}

/// In a run that was changed over to, all that is not of any run is the user's, and all else stays as it was.
DebuggerSession Debugger::present_session() {
  DebuggerSession session = session_of(model_, view_->camera());
  if (model_.run().path() == recording_ || !last_) {
    last_ = session;
    return session;
  }
  last_->breakpoints = session.breakpoints;
  last_->watches = session.watches;
  last_->bookmarks = session.bookmarks;
  return *last_;
}

std::string Debugger::keep_session() {
  if (keeper_.file().empty()) return "";
  DebuggerSession session = present_session();
  const bool unasked = keeper_.file() == session_path(recording_);
  std::error_code error;
  const bool is_new = unasked && !std::filesystem::exists(keeper_.file(), error);
  if ((is_new || offered_) && !has_anything(session)) return "";
  if (offered_) session = join(std::move(session), *offered_);
  std::string problem = keeper_.keep(session);
  say_note(keeper_);
  if (!problem.empty()) report(problem, true);
  return problem;
}

void Debugger::keep_session_at(double now) {
  if (offered_ || now < saved_at_ + kSavePause) return;
  saved_at_ = now;
  (void)keep_session();
}

bool Debugger::open(const std::filesystem::path& file) {
  std::unique_ptr<Run> run;
  try {
    run = open_run(file);
  } catch (const std::runtime_error& error) {
    report(error.what(), true);
    return false;
  }
  (void)keep_session();
  context_.make_current();
  other_view_.reset();
  other_ = nullptr;
  view_.reset();
  DebuggerModel model(std::move(run));
  model.on_long_work = std::move(model_.on_long_work);
  model.work_folder = model_.work_folder;
  model_ = std::move(model);
  run_ = &model_.run();
  view_ = make_scene_view(context_.functions(), model_.run());
  PanelMemory memory;
  memory.search.history = std::move(memory_.search.history);
  memory.window = std::move(memory_.window);  // the user's, not the recording's
  memory_ = std::move(memory);
  recording_ = file;
  last_.reset();
  savers_.clear();
  history_ = {};
  model_.go_to_opening();
  report("opened " + file.string(), false);
  begin_session();
  remember_recording();
  return true;
}

void Debugger::remember_in(const std::filesystem::path& folder) {
  recent_ = RecentFiles(folder);
  remember_recording();
}

void Debugger::remember_recording() {
  if (!is_scratch()) recent_.add(recording_);
  memory_.session.recent = recent_.files();
}

void Debugger::answer_offer(bool goes_on) {
  memory_.session.offer.clear();
  memory_.session.offer_warning.clear();
  const auto offered = std::exchange(offered_, std::nullopt);
  if (!offered) return;
  if (!goes_on) {
    keeper_.begin_anew();
    return report("began anew; the earlier session becomes " + keeper_.name_of_earlier().filename().string() +
                      " with the first change",
                  false);
  }
  memory_.welcome = false;
  go_on_with(join(*offered, present_session()));
  spare(keeper_, *offered);
}

void Debugger::take_back(int changes) {
  for (; changes != 0; changes += changes > 0 ? -1 : 1) {
    const auto state = changes > 0 ? history_.undo() : history_.redo();
    if (!state)
      return report(
          changes > 0 ? "no change of the view to take back" : "no change of the view to make again", false);
    model_.view = state->settings;
    model_.select(state->selection);
    model_.timeline.window = state->window;
    view_->set_camera(state->camera);
  }
}

void Debugger::do_what_was_asked(const DebuggerInput& input) {
  if (!input.dropped.empty()) memory_.session.open = input.dropped;
  if (const auto answer = std::exchange(memory_.session.answer, std::nullopt)) answer_offer(*answer);
  take_back(std::exchange(memory_.session.changes_back, 0));
  if (const auto file = std::exchange(memory_.session.open, std::nullopt)) open(*file);
}

void Debugger::see_view(const DebuggerInput& input) {
  if (history_of_ != &model_.run()) history_ = {};
  history_of_ = &model_.run();
  const bool moved = seen_at_ != model_.run().position();
  seen_at_ = model_.run().position();
  const bool held = input.buttons[0] || input.buttons[1] || input.buttons[2];
  history_.see({model_.view, view_->camera(), model_.timeline.window, model_.selection()},
               {held, moved, input.seconds});
}

bool Debugger::take_session_key(const DebuggerInput& input) {
  const Key key = *input.key;
  SessionMemory& session = memory_.session;
  if (!session.offer.empty() && (key == Key::enter || key == Key::escape)) {
    session.answer = key == Key::enter;
    return true;
  }
  if (key == Key::b && input.shift) {
    const Position here = model_.run().position();
    model_.bookmarks.try_emplace(here);
    session.note_of = here;
    return true;
  }
  if (!input.control) return false;
  switch (key) {
    case Key::z:
      session.changes_back = input.shift ? -1 : 1;
      return true;
    case Key::y:
      session.changes_back = -1;
      return true;
    case Key::c:
      session.copy = CopyWish{"", input.shift};
      return true;
    case Key::o:
      open_search(memory_.search);
      memory_.search.text = "open ";
      return true;
    default:
      return false;
  }
}

}  // namespace kerf
