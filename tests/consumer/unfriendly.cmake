# All headers and a model with all warnings, included as ordinary headers rather than system headers, after macros of
# other libraries.
set(folder ${CMAKE_CURRENT_BINARY_DIR}/unfriendly)
file(GLOB headers RELATIVE ${KANEXPR_SOURCE}/include ${KANEXPR_SOURCE}/include/kanexpr/*.hpp)
list(FILTER headers EXCLUDE REGEX "/mp_units\\.hpp$") # requires mp-units
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n")
list(APPEND headers "#include <kanexpr/robots/read_sdf.hpp>\n" "#include <kanexpr/animate/picture_of.hpp>\n"
  "#include <kanexpr/flexible/read_sid.hpp>\n" "#include <kanexpr/flexible/read_modes.hpp>\n")
list(JOIN headers "" headers)
file(WRITE ${folder}/every_header.hpp "${headers}")

# A macro for each letter precedes the headers; the model that follows them uses these letters as names again.
set(letters)
set(no_letters)
foreach(letter IN ITEMS A B C D E F G H I J K L M N O P Q R S T U V W X Y Z)
  string(APPEND letters "#undef ${letter}\n#define ${letter} harm\n")
  string(APPEND no_letters "#undef ${letter}\n")
endforeach()
file(WRITE ${folder}/letters.hpp "${letters}")
file(WRITE ${folder}/no_letters.hpp "${no_letters}")

# After the headers, the macros have their original meaning.
file(GLOB_RECURSE files ${KANEXPR_SOURCE}/include/kanexpr/*.hpp)
set(others)
foreach(file IN LISTS files)
  file(STRINGS ${file} lines REGEX "^#include <")
  list(APPEND others ${lines})
endforeach()
list(FILTER others EXCLUDE REGEX "<kanexpr/")
list(REMOVE_DUPLICATES others)
list(TRANSFORM others REPLACE "#include (<.+>)" "#if __has_include(\\1)\n#include \\1\n#endif") # of another version
list(JOIN others "\n" others)
file(WRITE ${folder}/others_headers.hpp "${others}\n")

add_library(consumer OBJECT unfriendly.cpp)
target_include_directories(consumer PRIVATE ${folder})
target_link_libraries(consumer PRIVATE kanexpr::hdf5 kanexpr::mpi kanexpr::animate kanexpr::fmi kanexpr::robots_sdf kanexpr::flexible_modes)
set_target_properties(consumer PROPERTIES CXX_STANDARD 20 CXX_EXTENSIONS OFF)
include(warnings.cmake)
target_compile_options(consumer PRIVATE ${warnings_of_a_consumer} $<$<CXX_COMPILER_ID:GNU>:-Wuseless-cast> -fsyntax-only)
