#pragma once
// A case with an include, for studies of it.

#include "base/error.hpp"
#include "study/sweepCases.hpp"
#include "support/folder.hpp"

namespace pfem::test {

class SweepFolder : public Folder {
protected:
    SweepFolder() {
        put("common", "h 0.5;\n");
        put("system/controlDict",
            "#include \"../common\"\nstartFrom startTime; endTime 2; deltaT #eval{ 0.1*$h };\n"
            "functions { tip { type probes; } }\n");
        put("system/meshDict", "#include \"../common\"\nmeshSize $h;   // the wanted edge\n");
        put("system/pfemSolution", "integration nodal; solid { damping 0.2; }\n");
        put("constant/materials", "E0 1e6;\nrubber { type neoHookean; E $E0; nu 0.3; }\nsteel { E $E0; }\n");
        put("constant/g", "value (0 -9.81 0);\n");
        put("constant/wave.csv", "0,1\n");
    }

    /// What the message of a UserError says; "" without one.
    template <class Action>
    static std::string complaint(Action action) {
        try {
            action();
            return "";
        } catch (const UserError& error) {
            return toString(error.where()) + ": " + error.what();
        }
    }

    static Sweep sweepOf(const std::string& text) { return readSweep(Dictionary::parse(text, "sweepDict")); }
    Dictionary of(const SweepCase& one, const char* file) const { return Dictionary::read(one.root / file); }

    /// Files by which a folder counts as a time.
    void addTime(const std::filesystem::path& folder, const std::string& time) const {
        for (const char* file : {"uniform/time", "fluid.vtu", "solid.vtu", "boundary.vtu"})
            put(std::filesystem::relative(folder, root) / time / file, "");
    }
};

/// The dictionaries `parameters` and `results` around their content.
inline std::string parameters(const std::string& text) { return "parameters { " + text + " }\n"; }
const std::string tip = "results { tip { function tip; } }\n";

}  // namespace pfem::test
