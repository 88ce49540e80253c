#pragma once
// The one place where a program learns of how many dimensions its case is.

#include <filesystem>
#include <type_traits>

#include "io/stateDimension.hpp"

namespace pfem {

/// f(std::integral_constant<int, Dim>()) for the dimension of the cells in a time folder:
///     withDimension(folder, [&](auto dim) { return run<dim.value>(theCase); })
template <class F>
auto withDimension(const std::filesystem::path& folder, F&& f) {
    if (stateDimension(folder) == 3) return f(std::integral_constant<int, 3>());
    return f(std::integral_constant<int, 2>());
}

}  // namespace pfem
