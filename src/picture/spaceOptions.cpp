#include "picture/spaceOptions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "application/optionValues.hpp"
#include "dictionary/function1.hpp"

namespace pfem {

namespace {

const std::vector<std::string> optionNames{"view", "perspective", "plane", "walls", "opacity"};

/// -plane '(0 0.1 0) (0 1 0)'
CuttingPlane planeOf(const Options& options) {
    CuttingPlane plane;
    try {
        const Dictionary dict = Dictionary::parse("plane " + options.get("plane") + ";", "-plane");
        TokenReader words = dict.reader("plane");
        plane.point = words.read<Eigen::Vector3d>();
        plane.normal = words.read<Eigen::Vector3d>();
        words.end();
    } catch (const UserError&) {
        throw UserError("-plane needs a point and a normal, '(x y z) (nx ny nz)', not '" + options.get("plane") + "'");
    }
    if (!(plane.normal.norm() > 0)) throw UserError("-plane needs a normal that is not zero");
    plane.normal.normalize();
    return plane;
}

Vec<3> upOf(const Case& theCase) {
    if (!std::filesystem::exists(theCase.constant("g"))) return Vec<3>::UnitZ();
    const auto gravity = readFunction1<Eigen::Vector3d>(Dictionary::read(theCase.constant("g")), "value");
    return upwards(gravity->value(0));
}

View viewOf(const Case& theCase, const Options& options) {
    View view;
    view.up = upOf(theCase);
    view.direction = usualDirection(view.up);
    if (options.found("view")) {
        const std::string& word = options.get("view");
        const auto& words = viewWords();
        if (std::find(words.begin(), words.end(), word) != words.end() || word.find('(') == std::string::npos)
            view.direction = viewDirection(word, view.up);
        else
            view.direction = optionValue<Eigen::Vector3d>(options, "view", "a word or a direction '(x y z)'");
        if (!(view.direction.norm() > 0)) throw UserError("-view needs a direction that is not zero");
    }
    if (options.found("perspective")) {
        view.angle = optionValue<double>(options, "perspective", "an angle");
        if (!(view.angle >= 1 && view.angle <= 120)) throw UserError("-perspective must be from 1 to 120 degrees");
    }
    return view;
}

WallLook wallsOf(const Options& options) {
    const auto& words = wallLooks();
    const auto found = std::find(words.begin(), words.end(), options.get("walls"));
    if (found == words.end()) throw UserError(notValid(options.get("walls"), "look of walls", words));
    return static_cast<WallLook>(found - words.begin());
}

}  // namespace

void addSpaceOptions(OptionsSpec& spec) {
    spec.add(
        "view", "word or '(x y z)'",
        fmt::format(
            "In space: from where one looks, {} or the direction to the eye (default from the front, right and above)",
            fmt::join(viewWords(), ", ")));
    spec.add("perspective", "degrees", "In space: the camera's angle (default: parallel rays)");
    spec.add("plane", "'(x y z) (nx ny nz)'",
             "In space: point and normal of a cut; what lies on the normal's side is taken away");
    spec.add("walls", "word", fmt::format("In space: {} (default inside)", fmt::join(wallLooks(), ", ")));
    spec.add("opacity", "number", "In space: of the fluid, 0 - 1 (default 1; 0.6 when only the solids are coloured)");
}

void refuseSpaceOptions(const Options& options) {
    for (const auto& name : optionNames)
        if (options.found(name)) throw UserError("-" + name + " is for cases in three dimensions");
}

SpaceOptions spaceOptions(const Case& theCase, const Options& options) {
    SpaceOptions space;
    space.view = viewOf(theCase, options);
    if (options.found("plane")) space.plane = planeOf(options);
    if (options.found("walls")) space.walls = wallsOf(options);
    if (options.found("opacity")) {
        space.opacity = optionValue<double>(options, "opacity", "a number from 0 to 1");
        if (!(*space.opacity >= 0 && *space.opacity <= 1)) throw UserError("-opacity must be from 0 to 1");
    }
    if (options.found("box")) {
        constexpr const char* form = "'((x y z) (x y z))'";
        const auto corners = optionValue<std::vector<Eigen::Vector3d>>(options, "box", form);
        if (corners.size() != 2 || !((corners[1] - corners[0]).minCoeff() > 0))
            throw UserError(fmt::format("-box needs the lowest and the highest corner: {}", form));
        space.box = {corners[0], corners[1]};
    }
    return space;
}

}  // namespace pfem
