# SPDX-License-Identifier: MIT
# `cpack` in the build folder: the Debian packages edgecase and libedgecase-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME edgecase)
set(CPACK_PACKAGE_CONTACT "The authors of Edgecase <edgecase@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact rasterization, held against real OpenGL")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL command development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME edgecase)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_COMMAND_DESCRIPTION
"exact rasterization, held against real OpenGL
 Renders test scenes exactly and with OpenGL, and says for every disagreement
 which rule it is about, why, and whether the specification allows it.")
# What is linked is found by dpkg-shlibdeps; what is opened at run time is not.
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_PACKAGE_DEPENDS "libegl1, libegl-mesa0, libgl1-mesa-dri")
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS "libosmesa6, libvulkan1, mesa-vulkan-drivers")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "chromium, python3")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libedgecase-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"exact rasterization: libraries for tests of other projects
 The exact rasterizer, the reader of case files and the judge as static
 libraries with a CMake package.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "edgecase (= ${PROJECT_VERSION}), libboost-dev, libfmt-dev, libhwy-dev, nlohmann-json3-dev, libzstd-dev, zlib1g-dev")

include(CPack)
