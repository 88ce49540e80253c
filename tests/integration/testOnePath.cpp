// Nodal and elemental integration are one code path: nothing outside of src/integration asks which of them it
// is.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

TEST(OnePath, onlyIntegrationTellsTheSchemesApart) {
    int files = 0, inside = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PFEM_SOURCE_DIR) / "src")) {
        const auto extension = entry.path().extension();
        if (extension != ".cpp" && extension != ".hpp") continue;
        ++files;
        std::ostringstream stream;
        stream << std::ifstream(entry.path()).rdbuf();
        const std::string text = stream.str(), path = entry.path().string();
        const bool asks = text.find("Integration::nodal") != std::string::npos ||
                          text.find("Integration::elemental") != std::string::npos;
        const bool isPlace = path.find("/src/integration/") != std::string::npos;
        inside += isPlace && asks;
        if (isPlace || path.ends_with("/momentum/controls.hpp")) continue;  // there the user's word becomes a scheme
        EXPECT_FALSE(asks) << path;
    }
    EXPECT_GT(files, 100);
    EXPECT_GT(inside, 0);
}
