// What a table of objects says of an import: names, colours and shapes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/overloaded.h"
#include "core/recording/recording_reader.h"
#include "core/replay/recorded_looks.h"
#include "tests/frames/import_program.h"
#include "viz/draw/recorded_bodies.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

class ImportObjects : public ImportProgram {
 protected:
  template <int D>
  [[nodiscard]] std::vector<Body<D>> bodies_of(const std::string& name, std::uint32_t step) const {
    RecordingReader<D> reader(path(name + ".kerf"));
    ObjectTable<D> table(VolumeKind::box);
    for (std::uint32_t k = 1; k <= step; ++k)
      for_each_request(reader.step(k).requests, table.kind(),
                       [&](const ObjectRequest<D>& request) { apply(request, table); });
    RecordedLooks<D> looks(reader);
    return recorded_bodies<D>(table, {looks.at(step), reader.shapes(), reader.info().marks});
  }
  [[nodiscard]] std::string complaint(const std::string& objects, const std::string& boxes = kFlat) const {
    return refused(write("boxes.csv", boxes), {"--objects", write("objects.csv", objects)});
  }

  static constexpr const char* kFlat =
      "step,object,min_x,max_x,min_y,max_y,angle\n"
      "1,10,0,2,0,2,\n1,20,4,7,0,3,0.7853981633974483\n1,30,10,14,0,4,\n"
      "2,20,5,8,0,3,\n2,30,10,14,0,4,1.5707963267948966\n";
  static constexpr const char* kSpatial =
      "step,object,min_x,max_x,min_y,max_y,min_z,max_z,qw,qx,qy,qz\n"
      "1,1,0,2,0,2,0,2,,,,\n1,2,4,6,0,4,0,2,0.7071067811865476,0,0,0.7071067811865476\n1,3,9,10,0,1,0,1,,,,"
      "\n";
};

TEST_F(ImportObjects, HaveNamesColoursAndShapes) {
  const std::string objects = write("objects.csv",
                                    "object,name,color,shape,radius,half_x,half_y,points\n"
                                    "10,\"left wheel, front\",#ff8000,ball,1,,,\n"
                                    "20,,,box,,1,1,\n30,flag,,polygon,,,,0 0; 0 4; 4 0\n");
  EXPECT_THAT(imported("a", write("boxes.csv", kFlat), {"--objects", objects}), Not(HasSubstr("odd")));
  const auto bodies = bodies_of<2>("a", 2);
  ASSERT_EQ(bodies.size(), 31U);
  EXPECT_EQ(bodies[10].shape, Shape<2>(Ball{1}));
  EXPECT_EQ(bodies[10].color, (Rgb{255, 128, 0}));
  EXPECT_EQ(bodies[20].shape, Shape<2>(Brick<2>{{1, 1}}));
  EXPECT_NEAR(bodies[20].pose.axes[0][1], std::sqrt(0.5), 1e-3) << "a blank angle is as before";
  EXPECT_EQ(bodies[30].shape, Shape<2>(Outline{{{4, 0}, {0, 4}, {0, 0}}})) << "counter-clockwise";
  EXPECT_NEAR(bodies[30].pose.axes[0][1], 1, 1e-3);
  const RecordingReader<2> reader(path("a.kerf"));
  EXPECT_EQ(reader.info().marks.title({10}, "10"), "10 left wheel, front");
}

TEST_F(ImportObjects, HaveMeshesInThreeDimensions) {
  (void)write("corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 3 4\n");
  const std::string objects = write("objects.csv",
                                    "object,shape,radius,half_x,half_y,half_z,mesh\n1,sphere,1,,,,\n2,box,,2,"
                                    "1,1,\n3,mesh,,,,,corner.obj\n");
  EXPECT_THAT(imported("a", write("boxes.csv", kSpatial), {"--objects", objects}), Not(HasSubstr("odd")));
  const auto bodies = bodies_of<3>("a", 1);
  ASSERT_EQ(bodies.size(), 4U);
  EXPECT_EQ(bodies[1].shape, Shape<3>(Ball{1}));
  EXPECT_NEAR(bodies[2].pose.axes[0][1], 1, 1e-3) << "a quarter turn about z";
  const auto triangles_of = [](const std::shared_ptr<const Surface>& it) { return it->triangles.size(); };
  const auto no_triangles = [](const auto&) { return std::size_t{0}; };
  EXPECT_EQ(std::visit(Overloaded{triangles_of, no_triangles}, bodies[3].shape), 3U)
      << "a face of four corners is two triangles";
  EXPECT_EQ(test::run_kerf({"verify", path("a.kerf")}).exit, 0);
}

/// A shape that does not fit is an oddity of the step, and its box is shown.
TEST_F(ImportObjects, AShapeThatIsLargerThanItsBoxIsNamed) {
  const std::string objects = write("objects.csv", "object,shape,radius\n10,ball,1.5\n99,ball,1\n");
  const std::string said = imported("a", write("boxes.csv", kFlat), {"--objects", objects});
  EXPECT_THAT(said, HasSubstr("1 box that is too small for the object's shape"));
  EXPECT_THAT(said, HasSubstr("boxes.csv, line 2: object 10 in step 1"));
  EXPECT_THAT(said, HasSubstr("objects.csv, line 3: object 99"));
  EXPECT_EQ(bodies_of<2>("a", 1)[10].shape, Shape<2>(Brick<2>{{1, 1}}));
  EXPECT_EQ(test::run_kerf({"verify", path("a.kerf")}).exit, 0);
}

TEST_F(ImportObjects, WhatIsNoneIsRefused) {
  EXPECT_THAT(complaint("10,ball,1\n"), HasSubstr("needs a heading with object"));
  EXPECT_THAT(complaint("object,shape\n10,ball\n"), HasSubstr("line 2: a ball needs radius, a length"));
  EXPECT_THAT(complaint("object,shape,radius\n10,ball,-1\n"), HasSubstr("is no length"));
  EXPECT_THAT(complaint("object,shape,radius\n10,ball,nan\n"), HasSubstr("is no length"));
  for (const std::string length : {"1e39", "1e-50"})
    EXPECT_THAT(complaint("object,shape,radius\n10,ball," + length + "\n"), HasSubstr("that no float holds"));
  EXPECT_THAT(complaint("object,shape\n10,mesh\n"), HasSubstr("there are ball, brick and polygon"));
  EXPECT_THAT(complaint("object,shape\n10,polygon\n"), HasSubstr("line 2: a polygon needs points"));
  EXPECT_THAT(complaint("object,shape,points\n10,polygon,0 0; 1 0\n"), HasSubstr("has no three points"));
  EXPECT_THAT(complaint("object,shape,points\n10,polygon,0 0; 1 0; 2 0\n"), HasSubstr("is not convex"));
  EXPECT_THAT(complaint("object,shape,points\n10,polygon,0 0; 4 0; 1 1; 0 4\n"), HasSubstr("is not convex"));
  EXPECT_THAT(complaint("object,shape,points\n10,polygon,0 0; x 0; 1 1\n"),
              HasSubstr("is no list of points"));
  EXPECT_THAT(complaint("object,color\n10,red\n"), HasSubstr("is no colour such as #1f77b4"));
  EXPECT_THAT(complaint("object,name\n10,\"a\tb\"\n"), HasSubstr("cannot be shown"));
  EXPECT_THAT(complaint("object,name\n10,a\n10,b\n"), HasSubstr("object 10 stands twice"));
  EXPECT_THAT(complaint("object,radius\n10,0.5\n"), HasSubstr("radius, is of an object without a shape"));
  EXPECT_THAT(complaint("object,shape,radius,half_x\n10,ball,1,1\n"),
              HasSubstr("half_x, is no measure of a ball"));
  EXPECT_THAT(complaint("color,object,name\n#1f77b4,10,wheel\n#1f77b,20,\n"),
              HasSubstr("line 3: '#1f77b' in column 1"));
  EXPECT_THAT(complaint("object,shape,mesh\n1,mesh,none.obj\n", kSpatial), HasSubstr("there is no file"));
  (void)write("bad.obj", "v 0 0 0\nf 1 2 9\n");
  EXPECT_THAT(complaint("object,shape,mesh\n1,mesh,bad.obj\n", kSpatial), HasSubstr("bad.obj has"));
  EXPECT_THAT(refused(write("b.csv", "step,object,min_x,max_x,min_y,max_y,angle\n1,1,0,1,0,1,inf\n")),
              HasSubstr("is no angle"));
  EXPECT_THAT(refused(write("b.csv", "step,object,min_x,max_x,min_y,max_y,qw\n1,1,0,1,0,1,1\n")),
              HasSubstr("2D are turned by angle"));
  EXPECT_THAT(refused(write("b.csv",
                            "step,object,min_x,max_x,min_y,max_y,min_z,max_z,rotation\n"
                            "1,1,0,1,0,1,0,1,90\n")),
              HasSubstr("3D are turned by qw,qx,qy,qz"));
  const std::string heading = "step,object,min_x,max_x,min_y,max_y,min_z,max_z,qw,qx,qy,qz\n";
  EXPECT_THAT(refused(write("b.csv", heading + "1,1,0,1,0,1,0,1,1,1,0,0\n")), HasSubstr("no rotation"));
  EXPECT_THAT(refused(write("b.csv", heading + "1,1,0,1,0,1,0,1,1,,0,0\n")), HasSubstr("four numbers"));
}

/// 0 was taken for what is no number.
TEST_F(ImportObjects, AMeshIsReadByLineOrRefused) {
  const std::string objects = "object,shape,mesh\n1,mesh,m.obj\n";
  for (const auto& [text, line] :
       {std::pair{"v 0,5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: 'v 0,5 0 0' is no vertex"},
        {"v 0 0 0\r\nv 1 x 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "line 2: 'v 1 x 0' is no vertex"},
        {"v 0 0 0\nv 1 0 0\n\nv 0 1\nf 1 2 3\n", "line 4: 'v 0 1' is no vertex"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 inf\nf 1 2 3\n", "line 3: 'v 0 1 inf' is no vertex"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\n", "line 5: 'f 1 2' is no face"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1,2,3 1 2\n", "line 4: 'f 1,2,3 1 2' is no face"}}) {
    (void)write("m.obj", text);
    EXPECT_THAT(complaint(objects, kSpatial), HasSubstr(line));
  }
  (void)write(
      "m.obj",
      "\xEF\xBB\xBFv +0. 0 0 # here\n  v\t1 0 .0 1 0 0\r\nvt 0,5\nmtllib none\nv 0 1e-2 0\nf 1 2/1 -1//2\n");
  EXPECT_THAT(imported("a", write("boxes.csv", kSpatial), {"--objects", write("objects.csv", objects)}),
              Not(HasSubstr("odd")));
}

}  // namespace
}  // namespace kerf::test
