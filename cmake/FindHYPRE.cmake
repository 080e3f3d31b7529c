# hypre as HYPRE::HYPRE, with the MPI that Debian builds it with; it brings no CMake configuration.

find_path(HYPRE_INCLUDE_DIR HYPRE.h PATH_SUFFIXES hypre)
find_library(HYPRE_LIBRARY HYPRE)
if(HYPRE_INCLUDE_DIR AND HYPRE_LIBRARY)
  find_package(MPI QUIET COMPONENTS C)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HYPRE REQUIRED_VARS HYPRE_LIBRARY HYPRE_INCLUDE_DIR MPI_C_FOUND)
mark_as_advanced(HYPRE_INCLUDE_DIR HYPRE_LIBRARY)

if(HYPRE_FOUND AND NOT TARGET HYPRE::HYPRE)
  add_library(HYPRE::HYPRE UNKNOWN IMPORTED)
  set_target_properties(HYPRE::HYPRE PROPERTIES
    IMPORTED_LOCATION ${HYPRE_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${HYPRE_INCLUDE_DIR})
  target_link_libraries(HYPRE::HYPRE INTERFACE MPI::MPI_C)
  target_compile_definitions(HYPRE::HYPRE INTERFACE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
endif()
