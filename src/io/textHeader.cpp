#include "io/textHeader.hpp"

namespace pfem {

std::string dictionaryHeader(const std::string& object, const std::string& location) {
    std::string line = "// ";
    for (int i = 0; i < 37; ++i) line += "* ";
    return "/*--------------------------------*- C++ -*----------------------------------*\\\n"
           "  libpfem: Particle Finite Element Method with nodal integration\n"
           "\\*---------------------------------------------------------------------------*/\n"
           "FoamFile\n{\n"
           "    version     2.0;\n    format      ascii;\n    class       dictionary;\n"
           "    location    \"" +
           location + "\";\n    object      " + object + ";\n}\n" + line + "//\n\n";
}

std::string dictionaryEndLine() { return "// " + std::string(73, '*') + " //\n"; }

}  // namespace pfem
