#include "frames/sequence/film_files.h"

#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {

FilmRequest parse_film_request(const std::string& video, const std::string& fps,
                               const std::string& contact_sheet, bool overwrite) {
  constexpr int kMostFps = 240;
  FilmRequest request{video, contact_sheet, 25, replace_if(overwrite)};
  if (!video.empty()) Video::check_extension(video);
  if (!contact_sheet.empty() && request.contact_sheet.extension() != ".png")
    throw UsageError("--contact-sheet '" + contact_sheet + "': give the file the extension .png");
  if (fps.empty()) return request;
  if (video.empty()) throw UsageError("--fps is of a film; give --video, too, or leave it out");
  const auto number = parse_number<int>(fps);
  if (!number || *number < 1 || *number > kMostFps)
    throw UsageError("--fps '" + fps + "' is not a whole number from 1 to " + std::to_string(kMostFps));
  request.fps = *number;
  return request;
}

void add_outputs(const FilmRequest& request, Outputs& outputs) {
  outputs.add_file(request.video);
  outputs.add_file(request.contact_sheet);
}

FilmFiles::FilmFiles(const FilmRequest& request, PictureSize size, std::uint32_t frames)
    : request_(request), strip_(frames) {
  if (!request.video.empty()) video_.emplace(request.video, size, request.fps, request.replace);
  if (request.contact_sheet.has_parent_path())
    make_writable_folder(request.contact_sheet.parent_path(), "--contact-sheet");
}

void FilmFiles::add(std::uint32_t index, const Image& image) {
  if (video_) video_->add(image.rgba);
  if (!request_.contact_sheet.empty() && strip_.is_chosen(index)) strip_.offer(index, image);
}

void FilmFiles::finish() {
  if (video_) video_->finish();
  if (!request_.contact_sheet.empty()) strip_.save(request_.contact_sheet, request_.replace);
}

}  // namespace kerf
