#include <cmath>
#include <string>
#include <utility>

#include "frames/commands/command.h"
#include "frames/import/import_boxes.h"
#include "frames/sequence/part_recording.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_config.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

/// "0.05" on each side, or "10%" of the extent.
Margin parse_margin(const std::string& text) {
  if (text.empty()) return {};
  const bool is_share = text.ends_with('%');
  const auto number =
      parse_number<double>(std::string_view(text).substr(0, text.size() - (is_share ? 1 : 0)));
  if (!number || !std::isfinite(*number))
    throw UsageError("--margin '" + text + "' is neither a length such as 0.05 nor a share such as 10%");
  return is_share ? Margin{0, *number / 100} : Margin{*number, 0};
}

class ImportCommand final : public Command {
 public:
  explicit ImportCommand(CLI::App& program);
  void run() const override;

 private:
  std::string boxes_;
  std::string pairs_;
  std::string out_;
  std::string config_;
  std::string margin_;
  std::string ignore_;
  std::string objects_;
  std::string structure_;
  bool unite_ = false;
  bool strict_ = false;
  bool overwrite_ = false;
};

ImportCommand::ImportCommand(CLI::App& program)
    : Command(program, "import", "Make a recording of another engine's boxes and pairs") {
  option("FILE", boxes_, "Their boxes, see below; - for standard input", "")->required();
  output("-o,--out", out_, "The recording")->required();
  option("--pairs", pairs_, "Their pairs: step,a,b", "FILE");
  option("--objects", objects_, "Names, colours and shapes of objects, see below", "FILE");
  option("--margin", margin_, "Their boxes are so much larger on each side, or by a share of their extent",
         "X|N%");
  option("--ignore", ignore_, "Pairs that they leave out by design: a,b", "FILE");
  option("--structure", structure_, "The nodes of their tree of boxes, see below", "FILE");
  option("--config", config_, "Parameters of our tree, see `kerf render --help`", "K=V,...");
  command_->add_flag(
      "--unite", unite_,
      "Unite the boxes that an object has in one step; what overlaps the joined box is a pair");
  command_->add_flag("--strict", strict_, "What is odd is an error, as for example an inverted box");
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier recording");
  command_->footer(
      R"(BOXES   step,object,min_x,max_x,min_y,max_y[,min_z,max_z][,fixed][,category,mask][,angle or ,qw,qx,qy,qz]
        Columns are found by the names in the heading, in any order (also xmin, lower_x, body, frame ...);
        without a heading they stand in this order, up to fixed. Steps are rising numbers or times, objects are
        any whole numbers of 64 bits, and both keep their names. A line adds an object or changes its box; where
        all bounds are blank, the object goes; where the object is blank, too, the step has this line and nothing
        else. Objects without a line stay as they are. fixed is 0 or 1: two fixed objects are no pair. Two
        objects are left out unless each has a category, a set of bits, in the mask of the other. An angle in
        radians, or in 3D a quaternion, is how the object's shape is turned.
OBJECTS object[,name][,color][,shape][,radius][,half_x,half_y[,half_z]][,points][,mesh]
        color is #1f77b4; shape is ball (radius), brick (half extents), polygon (points 'x y; x y; x y') or, in
        3D, mesh (an OBJ file). The middle of a shape's box is the middle of the object's box.
PAIRS   step,a,b   of the boxes' first step or a later one, also one without boxes
        What is wrong with them is then found by `kerf step FILE --to 'missed>0'` and `kerf explain`. What
        --margin, --ignore and masks declare is counted apart, as ignored, and so are pairs that touch only in
        the digits that were written (%g, %.3f), as undecided: write floats with 9 digits, doubles with 17.
NODES   step,node,parent,min_x,max_x,min_y,max_y[,min_z,max_z],object[,leaf][,margin]
        The whole tree after a step, in any order of lines; a step without lines has no known tree, one with a
        line of nothing but the step an empty one. Nodes are any whole numbers of 64 bits but -1. A root has no
        parent, or -1. An object stands at the node that holds it; several are 3 7 12. leaf, 0 or 1, is what the
        engine calls the node, margin how much larger it says it makes the boxes of its objects on each side;
        blank where it placed one tight. `kerf lint FILE --structure` says what is wrong, `kerf explain FILE
        --pair` at which node a pair was lost, `kerf debug FILE` draws it.)");
}

void ImportCommand::run() const {
  ImportRequest request;
  request.boxes = boxes_;
  request.pairs = pairs_;
  request.ignore = ignore_;
  request.objects = objects_;
  request.structure = structure_;
  request.config = parse_config("--config", config_, {});
  request.margin = parse_margin(margin_);
  for (const auto& [option, text] : {std::pair("--margin", &margin_), std::pair("--ignore", &ignore_)})
    if (!text->empty() && pairs_.empty())
      throw UsageError(std::string(option) +
                       " is for judging their pairs; give --pairs, too, or leave it out");
  request.unite = unite_;
  request.strict = strict_;
  Outputs outputs({boxes_, pairs_, ignore_, objects_, structure_}, overwrite_);
  outputs.add_recording(out_);
  const InterruptGuard interrupt;  // before there is a part that an interrupt would leave
  PartRecording part(out_, outputs.replace());
  request.out = part.path();
  part.write([&] {
    import_boxes(request, interrupt);
    part.keep();
  });
}

}  // namespace

AnyCommand make_import_command(CLI::App& program) { return std::make_unique<ImportCommand>(program); }

}  // namespace kerf
