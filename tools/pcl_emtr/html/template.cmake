# Makes a source of html_template() from the files of the page that Python uses too:
#   cmake -D TEMPLATE=<pyemtr/html/template> -D OUTPUT=<file.cpp> -P template.cmake
# A file of scripts is put in where the page has its mark, as pyemtr/html/template_files.py does.
cmake_minimum_required(VERSION 3.18)

file(READ "${TEMPLATE}/page.html" page)
foreach(part "head head.html" "header header.html" "view view.html" "style page.css" "advice advice.json"
        "three three.min.js" "script charts.js scene.js pair_view.js page.js")
  string(REPLACE " " ";" files "${part}")
  list(POP_FRONT files mark)
  set(content "")
  foreach(name IN LISTS files)
    file(READ "${TEMPLATE}/${name}" text)
    string(APPEND content "${text}")
  endforeach()
  string(REPLACE "@${mark}@" "${content}" page "${page}")
endforeach()

file(WRITE "${OUTPUT}" "#include \"html/template.h\"\n\nnamespace cli {\n\n"
  "const char* html_template() {\n  return R\"emtr_page(" "${page}" ")emtr_page\";\n}\n\n"
  "}  // namespace cli\n")
