#include "case/case.hpp"

#include "base/error.hpp"

namespace pfem {

Case::Case(const std::filesystem::path& root, const std::string& program) {
    std::error_code error;
    if (!std::filesystem::is_directory(root, error))
        throw UserError(program + ": cannot open case directory \"" + root.string() + "\"");
    root_ = std::filesystem::canonical(root, error);
    if (error) throw UserError(program + ": cannot open case directory \"" + root.string() + "\"");
}

std::string Case::name() const { return root_.filename().string(); }

}  // namespace pfem
