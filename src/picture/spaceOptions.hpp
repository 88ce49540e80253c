#pragma once
// The options of pictures in space.

#include "application/options.hpp"
#include "picture/scene.hpp"

namespace pfem {

void addSpaceOptions(OptionsSpec& spec);

/// Throws UserError when one of them was given.
void refuseSpaceOptions(const Options& options);

/// "Up" is against the gravity of the case. Throws UserError.
SpaceOptions spaceOptions(const Case& theCase, const Options& options);

}  // namespace pfem
