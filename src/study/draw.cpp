#include "study/draw.hpp"

#include <iostream>

#include "base/error.hpp"
#include "study/runProgram.hpp"

namespace pfem {

void drawPicture(const std::filesystem::path& folder, const std::string& name) {
    const auto log = folder / "log.gnuplot";
    try {
        std::filesystem::remove(log);
        if (runProgram({"gnuplot", name + ".gp"}, folder, log) != 0)
            std::cerr << "--> PFEM Warning: gnuplot could not draw " << name << ".gp: see \"" << log.string() << "\"\n";
    } catch (const UserError& error) {
        std::cerr << "--> PFEM Warning: no picture: " << error.what() << "; draw it with  gnuplot " << name << ".gp\n";
    }
}

}  // namespace pfem
