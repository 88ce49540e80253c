#include "mesher/nature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "dictionary/expression.hpp"
#include "dictionary/function1.hpp"

namespace pfem {

template <>
Vec<2> toPoint<2>(const Dictionary& dict, const std::string& key, const std::vector<double>& c) {
    if (c.size() == 2 || (c.size() == 3 && c[2] == 0)) return {c[0], c[1]};
    if (c.size() == 3) dict.fatal(key, fmt::format("'{}' leaves the plane: z is {:g} there; write (x y)", key, c[2]));
    dict.fatal(key, fmt::format("A point of '{}' has {} coordinates; write (x y)", key, c.size()));
}

template <>
Vec<3> toPoint<3>(const Dictionary& dict, const std::string& key, const std::vector<double>& c) {
    if (c.size() == 3) return {c[0], c[1], c[2]};
    dict.fatal(key, fmt::format("A point of '{}' has {} coordinates; write (x y z)", key, c.size()));
}

namespace {

template <int Dim>
void readVelocity(const Dictionary& dict, Nature<Dim>& body) {
    if (!dict.found("velocity")) return;
    TokenReader tokens = dict.reader("velocity");
    if (!tokens.peek().isWord()) {
        body.velocity = toPoint<Dim>(dict, "velocity", dict.get<std::vector<double>>("velocity"));
        return;
    }
    const auto word = tokens.read<std::string>();
    if (word != "expression") dict.fatal("velocity", notValid(word, "function of the place", {"expression"}));
    const auto formulas = tokens.read<std::vector<std::string>>();
    tokens.end();
    if (formulas.size() != Dim && formulas.size() != 3)
        dict.fatal("velocity",
                   fmt::format("A velocity needs a formula for each component: expression (\"-2*y\" \"2*x\"{})",
                               Dim == 2 ? "" : " \"0\""));
    std::vector<std::string> names{"x", "y"};
    if (Dim == 3) names.emplace_back("z");
    std::vector<std::shared_ptr<Expression>> u;
    for (const auto& formula : formulas)
        u.push_back(std::make_shared<Expression>(formula, names, dict.where("velocity")));
    body.velocityField = [u, dict](const Vec<Dim>& x) {
        const auto at = [&](std::size_t k) {
            if constexpr (Dim == 2)
                return (*u[k])({x[0], x[1]});
            else
                return (*u[k])({x[0], x[1], x[2]});
        };
        if (Dim == 2 && u.size() == 3) demandPlane(dict, "velocity", at(2));
        Vec<Dim> v;
        for (int d = 0; d < Dim; ++d) v[d] = at(static_cast<std::size_t>(d));
        return v;
    };
}

}  // namespace

template <int Dim>
void readNature(const Dictionary& dict, const std::vector<std::string>& materials, Nature<Dim>& body) {
    body.type = dict.choice("type", {"fluid", "solid"}) == "fluid" ? BodyType::fluid : BodyType::solid;
    body.material = dict.get<std::string>("material");
    if (std::find(materials.begin(), materials.end(), body.material) == materials.end())
        dict.fatal("material", notValid(body.material, "material", materials));
    readVelocity(dict, body);
}

template void readNature<2>(const Dictionary&, const std::vector<std::string>&, Nature<2>&);
template void readNature<3>(const Dictionary&, const std::vector<std::string>&, Nature<3>&);

}  // namespace pfem
