// Begins a case: a commented template is copied into a new folder.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "application/runApplication.hpp"
#include "base/error.hpp"
#include "dictionary/files.hpp"

using namespace pfem;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> templates = {"damBreak", "gmsh"};

OptionsSpec newCaseOptions() {
    OptionsSpec spec;
    spec.arguments = {"folder"};
    return spec.add(
        "template", "name",
        "damBreak (default): water and an elastic wall, every dictionary explained; gmsh: the mesh comes from a "
        "file of Gmsh");
}

fs::path templateFolder(const std::string& name) {
    if (std::find(templates.begin(), templates.end(), name) == templates.end())
        throw UserError(notValid(name, "template", templates));
    const auto found = findEtc(fs::path("templates") / name / "system/meshDict");
    if (!found) throw UserError("the templates are not found: type  . <libpfem>/etc/bashrc  first");
    return found->parent_path().parent_path();
}

}  // namespace

int main(int argc, char** argv) {
    return runApplication(
        argc, argv, "Begin a case: copy a commented template into a new folder.", newCaseOptions(),
        [](const Options& options) {
            const fs::path folder = options.openCase().root() / options.arguments().front();
            const fs::path source = templateFolder(options.get("template", templates.front()));
            std::error_code error;
            if (fs::exists(folder, error) && !fs::is_empty(folder, error))
                throw UserError("\"" + folder.string() + "\" is there already, and not empty");
            fs::create_directories(folder, error);
            if (!error) fs::copy(source, folder, fs::copy_options::recursive, error);
            if (error) throw UserError("cannot make the case \"" + folder.string() + "\": " + error.message());
            std::cout << fmt::format("{}: a case to change. Try it:\n\n    cd {} && ./Allrun\n\n", folder.string(),
                                     options.arguments().front());
            return 0;
        });
}
