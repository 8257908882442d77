/// Clouds that are damaged or meant to do harm: each gets one sentence that names the file, the place and the fault.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/cloud/read_cloud.h"
#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::cloud {
namespace {

struct Malformed {
  std::string name;  ///< of the case
  std::string file;
  std::string content;
  std::string sentence;  ///< expected after "PATH: "
};

void PrintTo(const Malformed& malformed, std::ostream* stream) { *stream << malformed.name; }

std::string header(const std::string& format, const std::string& count, const std::string& type = "float") {
  std::string text = "ply\nformat " + format + " 1.0\nelement vertex " + count + "\n";
  for (const char* property : {"x", "y", "z", "nx", "ny", "nz"}) text += "property " + type + " " + property + "\n";
  return text + "end_header\n";
}

/// The corners of a cube with diagonal normals, rounded to three digits: a good cloud of eight lines.
std::string cube() {
  std::string text;
  for (const char* x : {"", "-"}) {
    for (const char* y : {"", "-"}) {
      for (const char* z : {"", "-"}) {
        text += std::string(x) + "1 " + y + "1 " + z + "1 " + x + "0.577 " + y + "0.577 " + z + "0.577\n";
      }
    }
  }
  return text;
}

std::string without_last_line(const std::string& text) { return text.substr(0, text.rfind('\n', text.size() - 2) + 1); }

std::string with(std::string text, const std::string& what, const std::string& instead) {
  return text.replace(text.find(what), what.size(), instead);
}

std::string pcd(const std::string& data, const std::string& body, std::size_t width = 8, std::size_t height = 1) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + std::to_string(width) + "\nHEIGHT " +
         std::to_string(height) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(width * height) + "\nDATA " + data + "\n" + body;
}

std::string range_grid(const std::string& columns, const std::string& rows, const std::string& cells, const std::string& body) {
  return "ply\nformat ascii 1.0\nobj_info num_cols " + columns + "\nobj_info num_rows " + rows +
         "\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement range_grid " + cells +
         "\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n" + body;
}

std::vector<Malformed> all() {
  const std::string ascii = header("ascii", "8");
  const std::string little = header("binary_little_endian", "8");
  const std::string zeros(8 * 24, '\0');
  std::string infinite = zeros;
  infinite.replace(2 * 24 + 4, 4, std::string("\x00\x00\x80\x7f", 4));
  const std::string mesh_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
  return {
      {"empty", "a.ply", "", "the file is empty; export or copy it again"},
      {"a field", "a.itf", "ITFB", "a.itf: is a field already; name the scan or the mesh"},
      {"a trace", "a.ply", "ITRC", "a.ply: is a trace; make points of what a hand felt with isotouch scan"},
      {"a pointer", "a.ply", "version https://git-lfs.github.com/spec/v1\n",
       "a.ply: is a Git LFS pointer; fetch the file with git lfs pull"},
      {"unknown kind", "a.dat", "1 2 3 0 0 1\n", "the kind of this file is not recognised"},
      {"stl", "a.stl", "solid\nendsolid\n", "an STL file holds triangles, not points"},
      {"no magic", "a.ply", "plain text\n", "line 1: a PLY file begins with a line 'ply'"},
      {"header cut short", "a.ply", "ply\nformat ascii 1.0\nelement vertex 8\nprop", "line 4: 'prop' is no keyword of a PLY header"},
      {"header without end", "a.ply", "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\n", "the file ends within its PLY header"},
      {"unknown version", "a.ply", with(ascii, "1.0", "2.0") + cube(), "line 2: PLY version '2.0' is unknown"},
      {"unknown format", "a.ply", with(ascii, "ascii", "base64") + cube(), "line 2: PLY format 'base64' is unknown"},
      {"unknown type", "a.ply", with(ascii, "float x", "real x") + cube(), "line 4: number type 'real' is unknown"},
      {"no format", "a.ply", with(ascii, "format ascii 1.0\n", "") + cube(), "the header ends without a 'format' line"},
      {"no vertices", "a.ply", "ply\nformat ascii 1.0\nelement face 0\nproperty float a\nend_header\n", "declares no element 'vertex'"},
      {"negative count", "a.ply", header("ascii", "-8") + cube(), "line 3: the count of element 'vertex' is '-8', not a whole number"},
      {"fractional count", "a.ply", header("ascii", "8.5") + cube(), "line 3: the count of element 'vertex' is '8.5', not a whole number"},
      {"count beyond 64 bits", "a.ply", header("ascii", "99999999999999999999999") + cube(), "line 3: the count of element 'vertex' is"},
      {"hostile count, ascii", "a.ply", header("ascii", "4000000000") + cube(),
       "declares 4000000000 rows of element 'vertex', more than the file has room"},
      {"hostile count, binary", "a.ply", header("binary_little_endian", "18446744073709551615") + zeros,
       "declares 18446744073709551615 rows"},
      {"property twice", "a.ply", with(ascii, "float y", "float x") + cube(), "line 5: property 'x' is declared twice"},
      {"element twice", "a.ply", with(ascii, "end_header", "element vertex 8\nend_header") + cube(),
       "line 10: element 'vertex' is declared twice"},
      {"property without element", "a.ply", "ply\nformat ascii 1.0\nproperty float x\n", "line 3: a property before the first element"},
      {"element without property", "a.ply", with(ascii, "end_header", "element edge 4000000000\nend_header") + cube(),
       "line 11: element 'edge' has no properties"},
      {"list as coordinate", "a.ply", with(ascii, "float y", "list uchar float y") + cube(), "property 'y' of element 'vertex' is a list"},
      {"missing coordinate", "a.ply", with(ascii, "property float z\n", "") + cube(), "element 'vertex' has no property 'z'"},
      {"part of a normal", "a.ply", with(ascii, "property float nz\n", "") + cube(), "element 'vertex' has only a part of nx, ny, nz"},
      {"binary body cut short", "a.ply", little + zeros.substr(0, 100), "declares 8 rows of element 'vertex', more than the file has room"},
      {"binary body too long", "a.ply", little + std::string(8 * 24, '\x3f') + "abcdef", "6 bytes follow the last row"},
      {"binary list cut short", "a.ply",
       with(little, "end_header", "element face 1\nproperty list uchar int vertex_indices\nend_header") + zeros + "\x03",
       "face 1 of 1: the file ends in the middle of it"},
      {"binary list of negative length", "a.ply",
       with(little, "end_header", "element face 1\nproperty list char int vertex_indices\nend_header") + zeros + "\xff",
       "face 1 of 1: list vertex_indices has an impossible length"},
      {"binary infinity", "a.ply", little + infinite, "vertex 3 of 8: y is not a finite number"},
      {"binary zero normals", "a.ply", little + zeros, "all normals are zero or not finite numbers; choose --normals estimate"},
      {"face without vertex", "a.ply",
       with(ascii, "end_header", "element face 1\nproperty list uchar int vertex_indices\nend_header") + cube() + "3 0 1 8\n",
       "line 21: a corner refers to a vertex that is not there; there are 8"},
      {"one line short", "a.ply", ascii + without_last_line(cube()),
       "line 17: the file ends after 7 of the 8 rows of element 'vertex'; it was cut short, or the count is wrong"},
      {"one line too many", "a.ply", ascii + cube() + "1 2 3 0 0 1\n", "line 19: more rows than the header declares"},
      {"nan", "a.ply", ascii + with(cube(), "1 1 -1", "1 nan -1"),
       "line 12: y is not a finite number; correct it, or save the cloud without this point"},
      {"nan for a normal", "a.ply", ascii + with(cube(), "0.577 -0.577 0.577", "0.577 nan 0.577"),
       "line 13: the normal is zero or not a finite number, as at 1 of 8 points; remove these points, or choose --normals estimate"},
      {"nan for a normal in text", "a.xyz", with(cube(), "0.577 -0.577 0.577", "nan nan nan"),
       "line 3: the normal is zero or not a finite number, as at 1 of 8 points; remove these points, or choose --normals estimate"},
      {"text in a row", "a.ply", ascii + with(cube(), "1 1 -1", "1 one -1"), "line 12: 'one' is no number; y should stand there"},
      {"number too many", "a.ply", ascii + with(cube(), "0.577\n", "0.577 9\n"), "line 11: '9' follows the last property"},
      {"normal far from unit", "a.xyz", with(cube(), "0.577 0.577 -0.577", "57 57 -57"), "line 2: the normal has length 98.7"},
      {"overflowing normal", "a.xyz", with(cube(), "0.577 0.577 -0.577", "1e200 1e200 1"), "line 2: the normal has length inf"},
      {"infinite coordinate", "a.xyz", with(cube(), "1 1 -1", "1 1e999 -1"),
       "line 2: number 2 is not a finite number; correct or remove the line"},
      {"huge coordinate", "a.xyz", with(cube(), "1 1 -1", "1 1e300 -1"), "line 2: a coordinate is larger than 1e12"},
      {"five columns", "a.xyz", "1 2 3 0 0\n",
       "line 1: 5 numbers; a line must hold x y z or x y z nx ny nz, or a first line must name the columns, such as x y z intensity"},
      {"decimal commas", "a.xyz", "1,5 2,25 -3,0\n", "line 1: its numbers have decimal commas; save them with decimal points"},
      {"decimal commas between semicolons", "a.xyz", "1,5;2;-3,0;0;0;1\n", "line 1: its numbers have decimal commas"},
      {"UTF-16", "a.txt", std::string("\xFF\xFE") + "1\0\n\0", "the text is encoded as UTF-16; save it as UTF-8"},
      {"something else for normals", "a.txt", "1 2 3 255 -128 0\n",
       "instead of 1, and 1 of 1 normals are that far off; normalise them, choose --normals estimate, or remove columns 4 to 6 if they "
       "hold "
       "something else"},
      {"colours from 0 to 1", "a.txt", "1 2 3 0.8 0.8 0.8\n", "the numbers in columns 4 to 6 are never negative and not of length 1"},
      {"nine columns", "a.txt", "1 2 3 255 255 255 0 0 1\n", "line 1: more than 6 numbers"},
      {"columns change", "a.pwn", cube() + "1 2 3\n",
       "line 9: 3 numbers; a line must hold x y z nx ny nz like the lines before; correct or remove it"},
      {"three columns", "a.xyz", "1 2 3\n4 5 6\n", "only 2 usable points"},
      {"stated count too large", "a.npts", "9\n" + cube(), "its first line states 9 points, but 8 follow"},
      {"stated count hostile", "a.npts", "99999999999999999999999\n" + cube(), "points, but 8 follow"},
      {"garbage", "a.xyz", "\x01\x02\xff\xfe garbage\n", "line 1: '\?\?\?\?' is no number"},
      {"a huge line", "a.xyz", std::string(1 << 20, 'x'), "line 1: 'xxxxxxxxxxxxxxxxxxxxxxxx...' is no number"},
      {"a huge line of numbers", "a.xyz",
       [] {
         std::string s;
         for (int i = 0; i < 100000; ++i) s += "1 ";
         return s;
       }(),
       "line 1: more than 6 numbers"},
      {"remarks only", "a.xyz", "# nothing\n\n", "there are no points in it"},
      {"seven points", "a.xyz", without_last_line(cube()), "only 7 usable points at different places; a body needs 8 or more"},
      {"one place", "a.xyz", "1 1 1 0 0 1\n1 1 1 0 0 1\n1 1 1 0 0 1\n1 1 1 0 0 1\n1 1 1 0 0 1\n1 1 1 0 0 1\n1 1 1 0 0 1\n1 1 1 0 0 1\n",
       "only 1 usable point"},
      {"obj without normals", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "only 3 usable points"},
      {"obj index beyond", "a.obj", mesh_obj + "f 1//1 2//1 4//1\n", "line 5: a corner refers to vertex 4, but 3 stand before it"},
      {"obj index zero", "a.obj", mesh_obj + "f 0//1 2//1 3//1\n", "line 5: a corner refers to vertex 0"},
      {"obj index before the first", "a.obj", mesh_obj + "f -4//1 2//1 3//1\n", "line 5: a corner refers to vertex -4"},
      {"obj normal beyond", "a.obj", mesh_obj + "f 1//1 2//2 3//1\n", "line 5: a corner refers to normal 2, but 1 stand before it"},
      {"obj index of text", "a.obj", mesh_obj + "f 1//1 b//1 3//1\n", "line 5: 'b' is no index of a vertex"},
      {"obj corner without normal", "a.obj", mesh_obj + "f 1//1 2//1 3\n", "line 5: a corner has no normal"},
      {"obj face of two", "a.obj", mesh_obj + "f 1//1 2//1\n", "line 5: a face needs three corners or more, this one has 2"},
      {"obj counts disagree", "a.obj", mesh_obj, "3 vertices and 1 normals without faces"},
      {"obj coordinate missing", "a.obj", "v 0 0\n", "line 1: the line ends where a coordinate should stand"},
      {"obj nan", "a.obj", "v 0 nan 0\n", "line 1: a coordinate is not a finite number; correct it, or save the model without this point"},
      {"e57", "a.e57", "ASTM-E57", "E57, LAS and LAZ files, which laser scanners write, are not read; open it in CloudCompare"},
      {"las by its ending", "a.LAZ", "LASF", "LAS and LAZ files"},
      {"e57 by its beginning", "a.dat", "ASTM-E57", "E57, LAS"},
      {"las by its beginning", "a.dat", "LASF", "E57, LAS"},
      {"depth image without a camera", "a.png", "\x89PNG\r\n\x1a\n", "a depth image needs its camera: give --intrinsics FX,FY,CX,CY"},
      {"range grid of another size", "a.ply", range_grid("2", "2", "3", "1 0\n0\n0\n"),
       "obj_info states 2 columns and 2 rows, but element 'range_grid' has 3 cells"},
      {"range grid that overflows", "a.ply", range_grid("9223372036854775808", "4", "0", ""), "but element 'range_grid' has 0 cells"},
      {"range grid too large", "a.ply", range_grid("100000", "100000", "10000000000", "1 0\n"),
       "the header declares 10000000000 rows of element 'range_grid', more than the file has room for"},
      {"cell beyond", "a.ply", range_grid("1", "2", "2", "0\n1 1\n"), "line 14: a cell refers to a vertex that is not there; there are 1"},
      {"cell before", "a.ply", range_grid("1", "2", "2", "0\n1 -1\n"), "line 14: a cell refers to a vertex that is not there"},
      {"pcd without data", "a.pcd", "VERSION 0.7\nFIELDS x y z\n", "the file ends within its PCD header; there is no line DATA"},
      {"pcd of text", "a.pcd", "plain text\n", "line 1: 'plain' is no keyword of a PCD header"},
      {"pcd without sizes", "a.pcd", "FIELDS x y z\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n", "the PCD header has no line SIZE"},
      {"pcd without z", "a.pcd", with(pcd("ascii", ""), "x y z", "x y w"), "the PCD header names no field 'z'"},
      {"pcd with x twice", "a.pcd",
       with(with(with(with(pcd("ascii", ""), "x y z", "x y z x"), "4 4 4", "4 4 4 4"), "F F F", "F F F F"), "1 1 1", "1 1 1 1"),
       "field 'x' is declared twice"},
      {"pcd with half a normal", "a.pcd",
       with(with(with(with(pcd("ascii", ""), "x y z", "x y z normal_x"), "4 4 4", "4 4 4 4"), "F F F", "F F F F"), "1 1 1", "1 1 1 1"),
       "only a part of normal_x, normal_y, normal_z"},
      {"pcd with few sizes", "a.pcd", with(pcd("ascii", ""), "4 4 4", "4 4"), "line 4: SIZE names fewer fields than FIELDS"},
      {"pcd with many types", "a.pcd", with(pcd("ascii", ""), "F F F", "F F F F"), "line 5: TYPE names more fields than FIELDS"},
      {"pcd with an odd size", "a.pcd", with(pcd("ascii", ""), "4 4 4", "4 4 3"),
       "field 'z' has TYPE F and SIZE 3, which are no number type"},
      {"pcd with an odd type", "a.pcd", with(pcd("ascii", ""), "F F F", "F F Q"), "line 5: type 'Q' is unknown to PCD"},
      {"pcd with a huge count", "a.pcd", with(pcd("ascii", ""), "1 1 1", "1 1 999999999"),
       "line 6: a count is '999999999', not a whole number"},
      {"pcd with several z", "a.pcd", with(pcd("ascii", ""), "1 1 1", "1 1 2"), "field 'z' has 2 numbers, not one"},
      {"pcd with no count", "a.pcd", with(pcd("ascii", ""), "1 1 1", "1 1 0"), "line 6: field 'z' has a count of 0"},
      {"pcd of a huge size", "a.pcd", with(with(pcd("binary", ""), "WIDTH 8", "WIDTH 4294967295"), "HEIGHT 1", "HEIGHT 4294967295"),
       "WIDTH 4294967295 times HEIGHT 4294967295 is not POINTS 8"},
      {"pcd of other points", "a.pcd", with(pcd("ascii", ""), "WIDTH 8", "WIDTH 7"), "WIDTH 7 times HEIGHT 1 is not POINTS 8"},
      {"pcd of a width beyond", "a.pcd", with(pcd("ascii", ""), "WIDTH 8", "WIDTH 99999999999"),
       "line 7: WIDTH is '99999999999', not a whole number"},
      {"pcd of a negative height", "a.pcd", with(pcd("ascii", ""), "HEIGHT 1", "HEIGHT -1"), "line 8: HEIGHT is '-1', not a whole number"},
      {"pcd with nan viewpoint", "a.pcd", with(pcd("ascii", ""), "0 0 0 1", "0 nan 0 1"),
       "line 9: a number of the viewpoint is not finite"},
      {"pcd with a viewpoint beyond all numbers", "a.pcd", with(pcd("ascii", ""), "0 0 0 1", "0 1e200 0 1"),
       "line 9: the viewpoint is farther away than 1e100"},
      {"pcd with half a viewpoint", "a.pcd", with(pcd("ascii", ""), "0 0 0 1 0 0 0", "0 0 0"),
       "line 9: the line ends where a number of the viewpoint"},
      {"pcd of unknown data", "a.pcd", pcd("zip", ""), "line 11: PCD data 'zip' is unknown"},
      {"pcd cut short", "a.pcd", pcd("ascii", "1.00 2 3\n4.00 5 6\n7.00 8 9\n1.00 1 1\n2.00 2 2\n"),
       "line 16: the file ends after 5 of its 8 points"},
      {"pcd cut far too short", "a.pcd", pcd("ascii", "1 2 3\n", 4000000000),
       "the header declares 4000000000 points, more than the file has room for"},
      {"pcd with a long line", "a.pcd", pcd("ascii", "1 2 3 4\n", 1), "line 12: '4' follows the last field of the point"},
      {"pcd with a short line", "a.pcd", pcd("ascii", "1 2\n", 1), "line 12: the line ends where z should stand"},
      {"pcd with more lines", "a.pcd", pcd("ascii", "1 2 3\n1 2 3\n", 1), "line 13: more points than the header declares"},
      {"pcd of words", "a.pcd", pcd("ascii", "1 b 3\n", 1), "line 12: 'b' is no number; y should stand there"},
      {"pcd binary cut short", "a.pcd", pcd("binary", std::string(8 * 12 - 1, '\0')),
       "the header declares 8 points, more than the file has room for"},
      {"pcd binary too long", "a.pcd", pcd("binary", std::string(8 * 12, '\0') + "abc"),
       "3 bytes follow the last point that the header declares"},
      {"pcd of nan", "a.pcd", pcd("ascii", "nan nan nan\nnan nan nan\n", 2), "none of its 2 points has finite coordinates"},
      {"pcd image of nan", "a.pcd", pcd("ascii", "nan nan nan\nnan nan nan\n", 1, 2), "there are no points in it"},
      {"pcd of nothing", "a.pcd", pcd("ascii", "", 0), "there are no points in it"},
      {"pcd compressed to nothing", "a.pcd", pcd("binary_compressed", "1234"), "the compressed points are not there; the file is damaged"},
      {"pcd compressed and cut", "a.pcd", pcd("binary_compressed", std::string("\x09\0\0\0\x60\0\0\0", 8) + "12345678"),
       "the compressed points should have 9 bytes, but 8 are there"},
      {"pcd compressed of another size", "a.pcd", pcd("binary_compressed", std::string("\x08\0\0\0\x61\0\0\0", 8) + "12345678"),
       "the compressed points unpack to 97 bytes, which are not 8 points of 12 bytes"},
      {"pcd compressed wrongly", "a.pcd", pcd("binary_compressed", std::string("\x08\0\0\0\x60\0\0\0", 8) + "12345678"),
       "the compressed points do not unpack to 96 bytes"},
      {"pcd compressed from nothing", "a.pcd",
       pcd("binary_compressed", std::string("\x01\0\0\0\x00\xff\xff\xff", 8) + "1", 4294967040 / 12),
       "the compressed points do not unpack to 4294967040 bytes"},
  };
}

class MalformedClouds : public ::testing::TestWithParam<Malformed> {};

TEST_P(MalformedClouds, GetOneClearSentence) {
  const ScratchFolder folder;
  const auto file = folder.write(GetParam().file, GetParam().content);
  CloudReport report;
  try {
    read_cloud(file, report);
    FAIL() << "was accepted";
  } catch (const InputError& e) {
    const std::string sentence = e.what();
    EXPECT_THAT(sentence, ::testing::StartsWith(file.string() + ": "));
    EXPECT_THAT(sentence, ::testing::HasSubstr(GetParam().sentence));
    EXPECT_THAT(sentence, ::testing::Not(::testing::HasSubstr("\n")));
    EXPECT_LT(sentence.size() - file.string().size(), 200U);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, MalformedClouds, ::testing::ValuesIn(all()), [](const auto& parameter) {
  std::string name = parameter.param.name;
  for (char& c : name) c = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '_';
  return name;
});

TEST(SoundClouds, TheCubeThatTheyAreMadeFromIsAcceptedInAnyDress) {
  const ScratchFolder folder;
  std::string windows = header("ascii", "8") + cube();
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) windows.replace(at, 1, "\r\n");
  for (const auto& [name, content] : {std::pair<std::string, std::string>{"a.ply", header("ascii", "8") + cube()},
                                      {"b.xyz", cube()},
                                      {"c.PWN", "8\n" + cube()},
                                      {"crlf.ply", windows},
                                      {"no-end.xyz", cube().substr(0, cube().size() - 1)}}) {
    CloudReport report;
    EXPECT_EQ(read_cloud(folder.write(name, content), report).size(), 8U) << name;
    EXPECT_THAT(report.warnings(), ::testing::IsEmpty()) << name;
  }
}

TEST(SoundClouds, OfWrongNormalsAreAcceptedWhereNormalsAreEstimated) {
  const ScratchFolder folder;
  for (const char* normal : {"nan nan nan", "0 0 inf", "0 0 0", "0 0 9"}) {
    for (const auto& [name, begin] : {std::pair<const char*, std::string>{"a.ply", header("ascii", "8")}, {"b.xyz", ""}}) {
      CloudReport report;
      const auto file = folder.write(name, begin + with(cube(), "0.577 0.577 -0.577", normal));
      EXPECT_EQ(read_cloud(file, report, true).size(), 8U) << name << ' ' << normal;
    }
  }
}

TEST(MissingClouds, AndFoldersAreRefused) {
  const ScratchFolder folder;
  CloudReport report;
  EXPECT_THROW(read_cloud(folder.path() / "missing.ply", report), InputError);
  EXPECT_THROW(read_cloud(folder.path(), report), InputError);
}

}  // namespace
}  // namespace isotouch::cloud
