// SPDX-License-Identifier: MIT
#include "casefile/mesh/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "casefile/loader.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Mesh mesh_of(const std::string& text) {
  LoadedMesh loaded = parse_mesh(text);
  EXPECT_EQ(loaded.message, "");
  return std::move(loaded.mesh);
}

TEST(Mesh, ReadsFacesInEveryForm) {
  for (const char* face : {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1",
                           "f -4 -3 -2", "f 1 2 3\r", "  f\t1  2 3 "}) {
    const Mesh mesh =
        mesh_of(std::string("# a comment\nmtllib a.mtl\no square\n") + kSquare +
                "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nusemtl red\ns off\ng one two\n" + face);
    ASSERT_EQ(mesh.size(), 3U) << face;
    EXPECT_EQ(mesh[1].position, (Vector{1, 0, 0}));
    EXPECT_EQ(mesh[2].position, (Vector{1, 1, 0}));
    EXPECT_FALSE(mesh[0].color.has_value());
    const bool has_uv = std::string(face).find("1/1") != std::string::npos;
    EXPECT_EQ(mesh[2].uv, has_uv ? std::optional(std::array{1.0F, 1.0F}) : std::nullopt) << face;
  }
}

TEST(Mesh, NumbersAreTheNearestFloats) {
  const Mesh mesh = mesh_of("v 0.1 -1.5e-3 +2. 1\nv .5 1e2 3\nv 0 0 0\nf 1 2 3\n");
  EXPECT_EQ(mesh[0].position, (Vector{0.1F, -0.0015F, 2}));
  EXPECT_EQ(mesh[1].position, (Vector{0.5F, 100, 3}));
}

TEST(Mesh, KeepsTheColoursOfItsVertices) {
  const Mesh mesh = mesh_of("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0 0 0 7\nf 1 2 3\n");
  EXPECT_EQ(mesh[0].color, (Color{1, 0, 0, 1}));
  EXPECT_EQ(mesh[1].color, (Color{0, 0.5F, 0, 1}));
  EXPECT_EQ(mesh[2].color, (Color{0, 0, 7, 1}));
}

TEST(Mesh, CutsFacesIntoTrianglesThatCoverThemOnce) {
  const Mesh square = mesh_of(std::string(kSquare) + "f 1 2 3 4\n");
  EXPECT_EQ(square.size(), 6U);
  const Mesh hexagon =
      mesh_of("v 2 0 0\nv 1 2 0\nv -1 2 0\nv -2 0 0\nv -1 -2 0\nv 1 -2 0\nf 1 2 3 4 5 6\n");
  ASSERT_EQ(hexagon.size(), 12U);
  for (const Mesh& mesh : {square, hexagon}) {
    double doubled = 0;
    for (std::size_t i = 0; i < mesh.size(); i += 3) {
      const Vector &a = mesh[i].position, &b = mesh[i + 1].position, &c = mesh[i + 2].position;
      const double area =
          static_cast<double>((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
      EXPECT_GT(area, 0);  // each winds as its face does
      doubled += area;
    }
    EXPECT_EQ(doubled, mesh.size() == 6 ? 2 : 24);
  }
}

TEST(Mesh, FacesComeInTheirOrder) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "v " + std::to_string(i) + " 0 0\n";
  for (int i = 1; i <= 298; i += 3)
    text += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) +
            "\ng group" + std::to_string(i) + "\n";
  const Mesh mesh = mesh_of(text);
  ASSERT_EQ(mesh.size(), 300U);
  for (std::size_t i = 0; i < 300; ++i) EXPECT_EQ(mesh[i].position[0], static_cast<float>(i));
}

TEST(Mesh, RefusesMoreTrianglesThanACaseMayHave) {
  std::string text = kSquare;
  for (std::size_t i = 0; i < kMaxVertices / 3; ++i) text += "f 1 2 3\n";
  EXPECT_EQ(parse_mesh(text).message, "");
  EXPECT_EQ(parse_mesh(text + "f 1 2 3\n").message, "the file's faces make 87382 triangles");
}

TEST(Mesh, ReadsFilesAsProgramsWriteThem) {
  const Mesh plain = mesh_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const char* text :
       {"\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "v 0 0 0 # the first\nv 1 0 0# the second\nv 0 1 0\n# none\nf 1 2 3 # all",
        "v 0 0 0\nv \\\n1 0 \\\n0\nv 0 1 0\nf 1 \\\n2 3\n",
        "v 0 0 0\r\nv 1 0\\\r\n 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        "v 0e500 1e-60 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}) {
    const Mesh mesh = mesh_of(text);
    ASSERT_EQ(mesh.size(), 3U) << text;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(mesh[i].position, plain[i].position) << text;
  }
}

TEST(Mesh, NamesTheLineOfAFault) {
  EXPECT_TRUE(parse_mesh("v 0 0\\\n\\\n 0\nv 1 0 0\nv x 1 0\n").message.starts_with("line 5: "));
  const LoadedMesh bow = parse_mesh(std::string(kSquare) + "f 1 2 3\nf 1 2 4 3\n");
  EXPECT_EQ(bow.message, "line 6: the face crosses itself");
  EXPECT_TRUE(bow.mesh.empty());
}

// Whatever a file holds, it is read or refused with a place and a remedy; indices lead nowhere
// else.
TEST(Mesh, SurvivesHostileText) {
  const std::string sound = std::string(kSquare) + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf -1 -2 -3\n";
  constexpr char kBytes[] = "vfl 0123456789-+./e\n\r\t\\#x\0\xFF";
  std::mt19937 random(3);
  int read = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = sound;
    for (unsigned i = 0; i < 1 + random() % 4; ++i) {
      const std::size_t at = random() % text.size();
      const char byte = kBytes[random() % (sizeof kBytes - 1)];
      if (random() % 3 == 0)
        text.erase(at, 1 + random() % 5);
      else if (random() % 2 == 0)
        text[at] = byte;
      else
        text.insert(at, 1 + random() % 3, byte);
    }
    const LoadedMesh loaded = parse_mesh(text);
    EXPECT_EQ(loaded.mesh.empty(), !loaded.message.empty()) << text;
    EXPECT_EQ(loaded.remedy.empty(), loaded.message.empty()) << loaded.message;
    for (const MeshVertex& vertex : loaded.mesh)
      for (const float number : vertex.position) EXPECT_TRUE(std::isfinite(number)) << text;
    read += loaded.message.empty() ? 1 : 0;
  }
  EXPECT_GT(read, 1000);
  EXPECT_LT(read, 19000);
}

std::string case_with(const std::string& mesh, const std::string& rest = "") {
  return R"({"title": "t", "rules": ["a.b"], "target": {"width": 8, "height": 8}, "draws": [
    {"primitive": "triangles", "mesh": ")" +
         mesh + R"("}])" + rest + "}";
}

TEST(Mesh, FilesStayInsideTheSuiteWhateverLinksSay) {
  const fs::path root = fs::temp_directory_path() / "edgecase-mesh-test";
  fs::remove_all(root);
  fs::create_directories(root / "cases" / "deep");
  fs::create_directories(root / "cases" / "meshes");
  const std::string text = "v 0 0 0\nv 0.5 0 0\nv 0 0.5 0\nf 1 2 3\n";
  std::ofstream(root / "outside.obj") << text;
  std::ofstream(root / "cases" / "meshes" / "a.obj") << text;
  fs::create_symlink("../../outside.obj", root / "cases" / "meshes" / "link.obj");
  const auto load = [&](const std::string& mesh) {
    return load_cases_text(case_with(mesh), root / "cases" / "deep" / "a.json", "deep/a");
  };
  EXPECT_EQ(load("../meshes/a.obj").cases.size(), 1U);
  EXPECT_EQ(load("../deep/../meshes/a.obj").cases.size(), 1U);
  for (const char* path : {"../meshes/link.obj", "../../outside.obj", "../../cases", "..", "."})
    EXPECT_EQ(load(path).diagnostics.size(), 1U) << path;
  fs::remove_all(root);
}

TEST(Mesh, OneFileCannotUseMeshesWithoutEnd) {
  const fs::path root = fs::temp_directory_path() / "edgecase-mesh-limit-test";
  fs::remove_all(root);
  fs::create_directories(root);
  std::ofstream stream(root / "a.obj");
  stream << "v 0 0 0\nv 0.5 0 0\nv 0 0.5 0\n";
  for (int i = 0; i < 20000; ++i) stream << "f 1 2 3\n";
  stream.close();
  const std::string sweep = R"(, "sweep": {"n": {"set": ["/target/width"],
    "range": {"from": 1, "to": LAST, "step": 1}}})";
  const auto load = [&](const std::string& last) {
    std::string text = sweep;
    text.replace(text.find("LAST"), 4, last);
    return load_cases_text(case_with("a.obj", text), root / "a.json", "a");
  };
  EXPECT_EQ(load("8").cases.size(), 8U);
  const LoadedCases many = load("40");
  ASSERT_FALSE(many.diagnostics.empty());
  EXPECT_NE(many.diagnostics[0].message.find("vertices of meshes"), std::string::npos)
      << many.diagnostics[0].message;
  fs::remove_all(root);
}

// The meshes of the suite: closed surfaces, each edge of which two triangles share in opposite
// directions.
TEST(Mesh, ThoseOfTheSuiteAreClosed) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(EDGECASE_ROOT) / "cases" / "meshes")) {
    if (entry.path().extension() != ".obj") continue;
    SCOPED_TRACE(entry.path().filename());
    ++files;
    std::ifstream stream(entry.path());
    std::ostringstream text;
    text << stream.rdbuf();
    const Mesh mesh = mesh_of(text.str());
    std::set<std::pair<Vector, Vector>> edges;
    double volume = 0;
    for (std::size_t i = 0; i < mesh.size(); i += 3) {
      const Vector* corner[] = {&mesh[i].position, &mesh[i + 1].position, &mesh[i + 2].position};
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_TRUE(edges.emplace(*corner[k], *corner[(k + 1) % 3]).second);
      const auto& [a, b, c] = corner;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        volume += static_cast<double>((*a)[k] * ((*b)[l] * (*c)[m] - (*b)[m] * (*c)[l]));
      }
    }
    for (const auto& [from, to] : edges) EXPECT_TRUE(edges.contains({to, from}));
    EXPECT_GT(volume, 0);  // counterclockwise seen from outside
  }
  EXPECT_GE(files, 5);
}

}  // namespace
}  // namespace edgecase
