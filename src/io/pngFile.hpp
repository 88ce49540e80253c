#pragma once
// Pictures as PNG files.

#include <filesystem>

#include "picture/image.hpp"

namespace pfem {

/// Complete or absent. Throws UserError when the file cannot be written.
void writePng(const std::filesystem::path& file, const Image& image);

}  // namespace pfem
