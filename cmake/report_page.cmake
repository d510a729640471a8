# The page that `sheer compare` fills in, whole, as C++: our own files of WEB/report and, where
# `npm ci` has brought them, the libraries in WEB/node_modules. Run as
#   cmake -D WEB=FOLDER -D TO=FILE.cpp -P report_page.cmake
set(modules ${WEB}/node_modules)
set(scripts "")
foreach(name data table plot budgets viewer curves layers failures main)
  file(READ ${WEB}/report/${name}.js text)
  string(APPEND scripts "${text}")
endforeach()
file(READ ${WEB}/report/page.css style)
file(READ ${WEB}/report/page.html page)

set(libraries "")
set(licences "none: this build had no web/node_modules, so that the page has no chart and no slider")
if(EXISTS ${modules}/chart.js/dist/chart.umd.min.js)
  set(licences "")
  foreach(file chart.js/dist/chart.umd.min.js img-comparison-slider/dist/index.js)
    file(READ ${modules}/${file} text)
    string(REGEX REPLACE "\n?//# sourceMappingURL=[^\n]*" "" text "${text}")
    string(APPEND libraries "${text}\n")
  endforeach()
  foreach(file chart.js/LICENSE.md @kurkle/color/LICENSE.md)
    file(READ ${modules}/${file} text)
    string(APPEND licences "${file}:\n${text}\n")
  endforeach()
  file(READ ${modules}/img-comparison-slider/package.json text)
  string(JSON licence GET "${text}" license)
  string(JSON version GET "${text}" version)
  string(APPEND licences "img-comparison-slider ${version}: ${licence} licence, as above\n")
  string(REPLACE "&" "&amp;" licences "${licences}")
  string(REPLACE "<" "&lt;" licences "${licences}")
endif()

string(REPLACE "@STYLE@" "${style}" page "${page}")
string(REPLACE "@LICENCES@" "${licences}" page "${page}")
string(REPLACE "@SCRIPTS@" "${scripts}" page "${page}")
string(REPLACE "@LIBRARIES@" "${libraries}" page "${page}")

file(WRITE ${TO}.html "${page}")
file(READ ${TO}.html bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
file(WRITE ${TO} "#include \"compare/report/report.h\"
namespace sheer {
static const unsigned char kBytes[] = {
${bytes}};
std::string_view report_page()
{
    return {reinterpret_cast<const char*>(kBytes), sizeof kBytes};
}
}  // namespace sheer
")
