#pragma once

namespace pfem {

/// Part of h that nobody sees: what moves less far within a step is at rest.
constexpr double unseenPart = 1e-8;

}  // namespace pfem
