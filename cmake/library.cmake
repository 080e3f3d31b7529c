# mote_library(<name> FOLDER <folder> [SOURCES <files>] [LINKS <targets>] [USES <targets>])
#
# A layer of mote. Its headers are included as "mote/<name>/...", and only targets that link the
# layer see them, so a dependency that the CMake files do not state does not compile. LINKS are
# part of its interface, USES are not.
function(mote_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FOLDER" "SOURCES;LINKS;USES")
  set(headers ${PROJECT_BINARY_DIR}/headers/${name})
  file(MAKE_DIRECTORY ${headers}/mote)
  if(NOT EXISTS ${headers}/mote/${name})
    file(CREATE_LINK ${arg_FOLDER} ${headers}/mote/${name} SYMBOLIC)
  endif()
  if(arg_SOURCES)
    add_library(mote_${name} STATIC ${arg_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(mote_${name} PRIVATE ${arg_USES})
  else()
    add_library(mote_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(mote::${name} ALIAS mote_${name})
  set_target_properties(mote_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(
    mote_${name} ${scope} $<BUILD_INTERFACE:${headers}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(mote_${name} ${scope} cxx_std_20)
  target_link_libraries(mote_${name} ${scope} ${arg_LINKS})
  install(TARGETS mote_${name} EXPORT mote)
  install(DIRECTORY ${arg_FOLDER}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mote/${name}
          FILES_MATCHING PATTERN "*.hpp")
  set_property(GLOBAL APPEND PROPERTY MOTE_LAYERS ${name})
endfunction()
