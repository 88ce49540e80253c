#pragma once
// A folder of a test's own, removed at its end.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace pfem::test {

class Folder : public testing::Test {
protected:
    Folder()
        : root(std::filesystem::temp_directory_path() /
               ("pfemTest." + std::to_string(getpid()) + "." +
                testing::UnitTest::GetInstance()->current_test_info()->name())) {
        std::filesystem::create_directories(root);
    }
    ~Folder() override { std::filesystem::remove_all(root); }

    void put(const std::filesystem::path& file, const std::string& text) const {
        std::filesystem::create_directories((root / file).parent_path());
        std::ofstream(root / file) << text;
    }

    std::filesystem::path root;
};

}  // namespace pfem::test
