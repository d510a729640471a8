# Installs a build, moves what was installed, and uses it as others would: its headers one by one,
# its tool, and examples/minimal, which finds it as a package. CMakeLists.txt says what is given.
cmake_minimum_required(VERSION 3.24)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(need_file path)
  if(NOT EXISTS "${path}")
    message(FATAL_ERROR "not installed: ${path}")
  endif()
endfunction()

unset(ENV{DESTDIR})
set(INSTALLED "${WORK}/installed")
set(PREFIX "${WORK}/moved")  # a package must not depend on where it was installed
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
set(config)
if(CONFIG)
  set(config --config ${CONFIG})
endif()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${INSTALLED} ${config})
file(RENAME "${INSTALLED}" "${PREFIX}")

# Everything public is there, and each header needs no other, nor any other folder.
file(GLOB headers RELATIVE "${SOURCE}/include" "${SOURCE}/include/sheer/*.h")
foreach(header IN LISTS headers)
  need_file("${PREFIX}/include/${header}")
  string(MAKE_C_IDENTIFIER "${header}" name)
  set(unit "${WORK}/${name}.cpp")
  file(WRITE "${unit}" "#include <${header}>\n#include <${header}>\n")
  run(${COMPILER} -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
    -I ${PREFIX}/include ${unit})
endforeach()
file(GLOB shaders RELATIVE "${SOURCE}" "${SOURCE}/shaders/sheer/*.glsl")
foreach(shader IN LISTS shaders)
  need_file("${PREFIX}/share/sheer/${shader}")
endforeach()
run(${PREFIX}/bin/sheer methods)

# The package names nothing of the machine that built it, nor what only building needs.
file(GLOB_RECURSE package "${PREFIX}/*/cmake/Sheer/*.cmake")
foreach(file IN LISTS package)
  file(READ "${file}" text)
  foreach(word IN ITEMS "${SOURCE}" "${BUILD}" sheer_flags nlohmann_json CLI11)
    string(FIND "${text}" "${word}" at)
    if(NOT at EQUAL -1)
      message(FATAL_ERROR "${file} mentions ${word}")
    endif()
  endforeach()
endforeach()

run(${CMAKE_COMMAND} -S ${SOURCE}/examples/minimal -B ${WORK}/example -G ${GENERATOR}
  -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_PREFIX_PATH=${PREFIX})
file(STRINGS "${WORK}/example/CMakeCache.txt" found REGEX "^Sheer_DIR:")
string(FIND "${found}" "${PREFIX}/" at)
if(at EQUAL -1)
  message(FATAL_ERROR "the example found another package: ${found}")
endif()
run(${CMAKE_COMMAND} --build ${WORK}/example ${config})
find_program(example minimal PATHS "${WORK}/example" "${WORK}/example/${CONFIG}" NO_DEFAULT_PATH
  REQUIRED)
run(${example})
