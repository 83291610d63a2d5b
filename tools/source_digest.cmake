# SPDX-License-Identifier: MIT
# Writes OUTPUT, a header with a digest of all files of FOLDER: two programs of the same sources find
# the same, whoever compiled them.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE sources ${FOLDER}/*.h ${FOLDER}/*.cpp)
set(digests)
foreach(source IN LISTS sources)
  file(SHA256 ${source} digest)
  string(APPEND digests ${digest})
endforeach()
string(SHA256 digest "${digests}")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
"// Made by tools/source_digest.cmake.
#pragma once
inline constexpr const char* kSourceDigest = \"@digest@\";
" @ONLY)
