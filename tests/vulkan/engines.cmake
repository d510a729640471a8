# Whether hashed_threshold.glsl compiles as engines take it along: as GLSL ES 3.0 and GLSL 4.5 in a
# fragment shader, and as HLSL behind three defines, as docs/alpha-testing.md says. Run with cmake -P;
# GLSLANG is the compiler, TEXTS the folder of texts, FOLDER where to write.
file(MAKE_DIRECTORY ${FOLDER})
set(text "")
foreach(name prelude random hashed_threshold)
  file(READ ${TEXTS}/${name}.glsl one)
  string(APPEND text "${one}")
endforeach()

function(expect_compiles file code)
  file(WRITE ${FOLDER}/${file} "${code}")
  execute_process(COMMAND ${GLSLANG} ${ARGN} ${FOLDER}/${file} WORKING_DIRECTORY ${FOLDER}
                  RESULT_VARIABLE result OUTPUT_VARIABLE output)
  if(NOT result EQUAL 0)
    message(SEND_ERROR "${file} does not compile:\n${output}")
  endif()
endfunction()

set(glsl_main "in vec3 place;\nin float opacity;\nout vec4 color;\nvoid main()\n{\n\
if (opacity < hashed_alpha_threshold(place, dFdx(place), dFdy(place), 1.0)) discard;\n\
color = vec4(1.0);\n}\n")
expect_compiles(es.frag "#version 300 es\nprecision highp float;\nprecision highp int;\n${text}${glsl_main}"
                --quiet)
expect_compiles(desktop.frag "#version 450\n${text}${glsl_main}" --quiet)
expect_compiles(hlsl.frag "#define vec3 float3\n#define floatBitsToUint asuint\n\
#define uintBitsToFloat asfloat\n${text}\
float4 main(float3 place : TEXCOORD0, float opacity : TEXCOORD1) : SV_Target\n{\n\
clip(opacity - hashed_alpha_threshold(place, ddx(place), ddy(place), 1.0));\n\
return float4(1, 1, 1, 1);\n}\n" -D -V -e main -o ${FOLDER}/hlsl.spv --quiet)
