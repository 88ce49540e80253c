#pragma once
// A case: the folder that a program works on. Nothing else is read or written.

#include <filesystem>
#include <string>

namespace pfem {

class Case {
public:
    /// Throws UserError `<program>: cannot open case directory "..."` when `root` is not a folder.
    explicit Case(const std::filesystem::path& root = ".", const std::string& program = "pfem");

    const std::filesystem::path& root() const { return root_; }
    std::string name() const;  // the folder's own name

    std::filesystem::path controlDict() const { return root_ / "system" / "controlDict"; }
    std::filesystem::path system(const std::string& file) const { return root_ / "system" / file; }
    std::filesystem::path constant(const std::string& file) const { return root_ / "constant" / file; }
    std::filesystem::path time(const std::string& timeName) const { return root_ / timeName; }
    std::filesystem::path postProcessing(const std::string& function, const std::string& startName) const {
        return root_ / "postProcessing" / function / startName;
    }

private:
    std::filesystem::path root_;  // absolute
};

}  // namespace pfem
