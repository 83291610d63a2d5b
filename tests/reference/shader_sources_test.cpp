// SPDX-License-Identifier: MIT
//
// Nothing that a case file says reaches a shader's text: it is chosen by enumerations alone. Scenes
// of every kind are prepared for a table of functions that keeps what it is told to compile, and
// all of it is among the texts that the enumerations' values make.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "casefile/loader.h"
#include "reference/program_cache.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

std::set<std::string> compiled;

void keep_source(GLuint, GLsizei count, const GLchar* const* texts, const GLint*) {
  for (GLsizei i = 0; i < count; ++i) compiled.insert(texts[i]);
}

GLuint create() {
  return 1;
}

// OpenGL of a version, 4.3 or 3.3, that compiles and links whatever it is given.
GladGLContext listening_gl(bool is_4_3) {
  GladGLContext gl{};
  gl.VERSION_4_3 = is_4_3 ? 1 : 0;
  gl.GetIntegerv = [](GLenum, GLint* value) { *value = 1; };
  gl.GetUniformLocation = [](GLuint, const GLchar*) { return 0; };
  gl.UseProgram = [](GLuint) {};
  gl.Uniform1i = [](GLint, GLint) {};
  gl.CreateShader = [](GLenum) { return create(); };
  gl.CreateProgram = [] { return create(); };
  gl.ShaderSource = keep_source;
  gl.CompileShader = [](GLuint) {};
  gl.GetShaderiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
  gl.AttachShader = [](GLuint, GLuint) {};
  gl.LinkProgram = [](GLuint) {};
  gl.GetProgramiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
  gl.DeleteShader = [](GLuint) {};
  gl.DeleteProgram = [](GLuint) {};
  return gl;
}

// What is compiled by `make`.
template <class Make>
std::set<std::string> sources_of(Make make) {
  compiled.clear();
  make();
  return std::exchange(compiled, {});
}

// Every text there is.
std::set<std::string> all_sources(const GladGLContext& gl) {
  return sources_of([&] {
    make_programs(gl);
    for (const AttributeLocation location :
         {AttributeLocation::center, AttributeLocation::centroid, AttributeLocation::sample})
      make_sampled_programs(gl, location);
    for (const bool query : {false, true})
      for (const int dimensions : {0, 1, 2})
        for (const LookupKind kind :
             {LookupKind::implicit, LookupKind::bias, LookupKind::lod, LookupKind::gradients})
          make_texture_programs(gl, {dimensions, kind}, query);
  });
}

class ShaderSources : public ::testing::TestWithParam<bool> {
 protected:
  std::set<std::string> sources_of_scene(const Scene& scene) {
    return sources_of([&] {
      ProgramCache cache(gl_, std::get<Programs>(make_programs(gl_)));
      for (const bool query : {false, true})
        EXPECT_EQ(cache.prepare(scene, !scene.textures.empty(), query), "");
    });
  }

  const GladGLContext gl_ = listening_gl(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Versions, ShaderSources, ::testing::Bool());

// Uniforms are numbered where GLSL can, and what fragments tell is stored where shaders can.
TEST_P(ShaderSources, AreThoseOfTheVersion) {
  for (const std::string& source : all_sources(gl_)) {
    EXPECT_TRUE(source.starts_with(GetParam() ? "#version 4" : "#version 330") ||
                source.starts_with("#version 450"))
        << source;
    EXPECT_EQ(source.find(") uniform ") != std::string::npos,
              GetParam() && source.find("uniform ") != std::string::npos)
        << source;
    const bool captures = source.find("buffer Capture") != std::string::npos;
    const bool has_words = source.find("#define WORDS") != std::string::npos;
    EXPECT_EQ(has_words, captures && !GetParam()) << source;
  }
}

TEST_P(ShaderSources, AreAFixedSetWhateverFilesSay) {
  const std::set<std::string> known = all_sources(gl_);
  EXPECT_GT(known.size(), 20U);
  std::set<std::string> used;
  std::size_t scenes = 0;
  for (const char* folder : {"tests/casefile/good", "cases/textures", "cases/samples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(EDGECASE_ROOT) / folder)) {
      if (entry.path().extension() != ".json") continue;
      const LoadedCases loaded = load_cases(entry.path(), "a");
      // Cases of a file differ in numbers and in words of enumerations.
      for (std::size_t i = 0; i < loaded.cases.size(); i += 1 + loaded.cases.size() / 8, ++scenes) {
        const std::set<std::string> sources = sources_of_scene(loaded.cases[i].scene);
        EXPECT_TRUE(std::includes(known.begin(), known.end(), sources.begin(), sources.end()))
            << loaded.cases[i].id;
        used.insert(sources.begin(), sources.end());
      }
    }
  }
  EXPECT_GT(scenes, 200U);
  // The files ask for most of them: textures of both kinds, and samples.
  EXPECT_GT(2 * used.size(), known.size());
}

// Words that would end a literal, a comment or a line, wherever a case has words of its own.
TEST_P(ShaderSources, HaveNoWordOfACase) {
  const std::string hostile = R"(*/ #error owned \" ); } void main() { discard; } //)";
  const auto text_with = [](const std::string& words, const std::string& tag) {
    return R"({"title": ")" + words + R"(", "why": ")" + words + R"(", "spec": ")" + words +
           R"(", "rules": ["a.b"], "tags": [")" + tag + R"("], "target": {"width": 4, "height": 4},
  "textures": [{"size": [2, 2], "checker": {}}],
  "draws": [{"primitive": "points", "vertices": [{"at": [1, 1], "uv": [0, 0]}],
             "state": {"texture": 0}}],
  "sweep": {")" +
           tag + R"(": {"set": ["/draws/0/vertices/0/x"], "values": [1, 2]}}})";
  };
  const LoadedCases plain = load_cases_text(text_with("t", "axis"), "a.json", "a");
  const LoadedCases spoilt =
      load_cases_text(text_with(hostile, "owned"), "a.json", "a */ #error owned");
  for (const Diagnostic& fault : spoilt.diagnostics) ADD_FAILURE() << to_string(fault);
  ASSERT_EQ(plain.cases.size(), 2U);
  ASSERT_EQ(spoilt.cases.size(), 2U);
  EXPECT_NE(spoilt.cases[0].title.find("#error owned"), std::string::npos);
  const std::set<std::string> sources = sources_of_scene(spoilt.cases[0].scene);
  EXPECT_EQ(sources, sources_of_scene(plain.cases[0].scene));
  for (const std::string& source : sources) EXPECT_EQ(source.find("owned"), std::string::npos);
}

}  // namespace
}  // namespace edgecase
