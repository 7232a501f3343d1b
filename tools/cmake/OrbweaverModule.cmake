# orbweaver_add_module(<id> SOURCES ... [LINK ...])
#
# A loadable module: <id>.so beside <id>.toml (its manifest) in lib/orbweaver/modules, exporting the entry
# point and nothing else. The manifest's text is compiled in, so that the loader can compare the two.
function(orbweaver_add_module id)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
    set(manifest ${CMAKE_CURRENT_SOURCE_DIR}/manifest.toml)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${manifest})
    file(READ ${manifest} text)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/generated/manifest_text.hpp @ONLY CONTENT
"#pragma once
namespace orbweaver {
inline constexpr const char* kManifest = R\"manifest(@text@)manifest\";
}
")
    add_library(${id} MODULE ${ARG_SOURCES})
    target_include_directories(${id} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/generated)
    target_link_libraries(${id} PRIVATE orbweaver_sdk ${ARG_LINK})
    target_link_options(${id} PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/tools/cmake/module.map
                                      -Wl,--as-needed)
    set_target_properties(${id} PROPERTIES PREFIX "" OUTPUT_NAME ${id}
        LIBRARY_OUTPUT_DIRECTORY ${ORBWEAVER_MODULE_DIR}
        LINK_DEPENDS ${PROJECT_SOURCE_DIR}/tools/cmake/module.map)
    configure_file(${manifest} ${ORBWEAVER_MODULE_DIR}/${id}.toml COPYONLY)
    install(TARGETS ${id} LIBRARY DESTINATION lib/orbweaver/modules)
    install(FILES ${manifest} DESTINATION lib/orbweaver/modules RENAME ${id}.toml)
endfunction()
