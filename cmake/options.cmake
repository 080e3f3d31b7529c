# Compiler flags: the same bits for every optimisation level, instruction set and thread count.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

# No contraction into fused operations, which would change bits with the instruction set; no errno
# and no traps from mathematics, which would stop the compiler from vectorising.
add_compile_options(-Wall -Wextra -Wno-missing-field-initializers -ffp-contract=off -fno-math-errno -fno-trapping-math)
if(NOT MOTE_PORTABLE)
  add_compile_options(-march=native)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  # Fused multiply-adds must be instructions: a pair loop that calls a function for each is many times slower.
  add_compile_options(-march=x86-64-v3)
endif()
if(MOTE_SANITIZE)
  # Checks of every access for null, alignment and dynamic type take longer to compile than all others
  # together, and a null access traps anyway. Watching the scope of every vector on the stack makes pair
  # loops compile seven times longer.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,alignment,vptr
                      -fno-sanitize-address-use-after-scope -fno-sanitize-recover=all -Og -g1)
  add_link_options(-fsanitize=address,undefined)
endif()
