// The reader of time folders under any bytes. The first byte says which file they stand for; the other files are those
// of the folder in PFEM_FUZZ_FOLDER, whose uniform/time has the word `none` for checksums, so that nothing is refused
// before it is read.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "io/stateFiles.hpp"

using namespace pfem;
namespace fs = std::filesystem;

namespace {

const char* const names[] = {"fluid.vtu", "solid.vtu", "boundary.vtu", "uniform/time"};

/// A copy of the good folder for this process.
const fs::path& folder() {
    static const fs::path copy = [] {
        const char* good = std::getenv("PFEM_FUZZ_FOLDER");
        if (good == nullptr) std::abort();
        const fs::path path = fs::temp_directory_path() / ("pfemFuzz-" + std::to_string(getpid()));
        fs::remove_all(path);
        fs::copy(good, path, fs::copy_options::recursive);
        return path;
    }();
    return copy;
}

const std::string& original(int file) {
    static const std::string texts[] = {readText(folder() / names[0]), readText(folder() / names[1]),
                                        readText(folder() / names[2]), readText(folder() / names[3])};
    return texts[file];
}

void put(int file, const char* bytes, std::size_t size) {
    std::ofstream(folder() / names[file], std::ios::binary).write(bytes, static_cast<std::streamsize>(size));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    if (size == 0) return -1;
    for (int file = 0; file < 4; ++file) original(file);
    const int file = data[0] % 4;
    put(file, reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        readState<2>(folder());
    } catch (const UserError& error) {
        if (error.where().file.empty()) __builtin_trap();
    }
    put(file, original(file).data(), original(file).size());
    return 0;
}
