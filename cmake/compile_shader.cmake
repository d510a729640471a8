# Compute shaders, from GLSL to SPIR-V that a driver must not rearrange.

set(SHEER_SHADER_TOOLS_FOUND OFF)
find_package(Python3 QUIET COMPONENTS Interpreter)
find_program(SHEER_GLSLANG glslangValidator)
find_program(SHEER_SPIRV_DIS spirv-dis)
find_program(SHEER_SPIRV_AS spirv-as)
find_program(SHEER_SPIRV_VAL spirv-val)
mark_as_advanced(SHEER_GLSLANG SHEER_SPIRV_DIS SHEER_SPIRV_AS SHEER_SPIRV_VAL)
if(Python3_FOUND AND SHEER_GLSLANG AND SHEER_SPIRV_DIS AND SHEER_SPIRV_AS AND SHEER_SPIRV_VAL)
  set(SHEER_SHADER_TOOLS_FOUND ON)
endif()

# sheer_compile_shader(SOURCE OUTPUT [REARRANGEABLE])
# OUTPUT is the .spv to make. Includes are looked for beside SOURCE and in shaders/. REARRANGEABLE
# leaves out the pass of scripts/no_contraction.py, for the test that it is needed.
function(sheer_compile_shader source output)
  cmake_parse_arguments(PARSE_ARGV 2 shader REARRANGEABLE "" "")
  cmake_path(GET source PARENT_PATH beside)
  cmake_path(RELATIVE_PATH output BASE_DIRECTORY ${CMAKE_BINARY_DIR} OUTPUT_VARIABLE name)
  file(GLOB_RECURSE texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*.glsl ${beside}/*.glsl)

  set(pass ${PROJECT_SOURCE_DIR}/scripts/no_contraction.py)
  set(decorate ${Python3_EXECUTABLE} ${pass})
  if(shader_REARRANGEABLE)
    set(decorate ${CMAKE_COMMAND} -E copy)
  endif()
  # The last step renames, so that nothing invalid passes for the result at the next build.
  add_custom_command(OUTPUT ${output}
    COMMAND ${SHEER_GLSLANG} --quiet -V --target-env vulkan1.1 -I${PROJECT_SOURCE_DIR}/shaders
            -o ${output}.compiled ${source}
    COMMAND ${SHEER_SPIRV_DIS} --raw-id -o ${output}.asm ${output}.compiled
    COMMAND ${decorate} ${output}.asm ${output}.decorated.asm
    COMMAND ${SHEER_SPIRV_AS} --target-env spv1.3 -o ${output}.assembled ${output}.decorated.asm
    COMMAND ${SHEER_SPIRV_VAL} --target-env vulkan1.1 ${output}.assembled
    COMMAND ${CMAKE_COMMAND} -E rename ${output}.assembled ${output}
    DEPENDS ${source} ${texts} ${pass}
    COMMENT "Shader ${name}"
    VERBATIM)
endfunction()
