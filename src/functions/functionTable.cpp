#include <map>

#include "case/timeFolders.hpp"
#include "functions/boundingBox.hpp"
#include "functions/energy.hpp"
#include "functions/fieldMinMax.hpp"
#include "functions/forces.hpp"
#include "functions/front.hpp"
#include "functions/functionObject.hpp"
#include "functions/line.hpp"
#include "functions/massLedger.hpp"
#include "functions/momentumBalance.hpp"
#include "functions/periodicFlow.hpp"
#include "functions/pressureSensor.hpp"
#include "functions/probes.hpp"
#include "functions/rigidBodyState.hpp"
#include "functions/surfaces.hpp"
#include "functions/volumeFlow.hpp"
#include "functions/waveGauge.hpp"
#include "functions/waveReflection.hpp"
#include "io/stateFiles.hpp"

namespace pfem {

namespace {

template <int Dim, class Function>
std::unique_ptr<FunctionObject<Dim>> make(const Dictionary& dict, const FunctionContext<Dim>& context) {
    return std::make_unique<Function>(dict, context);
}

template <int Dim>
std::map<std::string, FunctionFactory<Dim>>& table() {
    static std::map<std::string, FunctionFactory<Dim>> entries{
        {"boundingBox", make<Dim, BoundingBox<Dim>>},
        {"energy", make<Dim, Energy<Dim>>},
        {"fieldMinMax", make<Dim, FieldMinMax<Dim>>},
        {"forces", make<Dim, Forces<Dim>>},
        {"front", make<Dim, Front<Dim>>},
        {"line", make<Dim, Line<Dim>>},
        {"massLedger", make<Dim, MassLedger<Dim>>},
        {"momentumBalance", make<Dim, MomentumBalance<Dim>>},
        {"periodicFlow", make<Dim, PeriodicFlow<Dim>>},
        {"pressureSensor", make<Dim, PressureSensor<Dim>>},
        {"probes", make<Dim, Probes<Dim>>},
        {"rigidBodyState", make<Dim, RigidBodyState<Dim>>},
        {"surfaces", make<Dim, Surfaces<Dim>>},
        {"volumeFlow", make<Dim, VolumeFlow<Dim>>},
        {"waveGauge", make<Dim, WaveGauge<Dim>>},
        {"waveReflection", make<Dim, WaveReflection<Dim>>},
    };
    return entries;
}

}  // namespace

template <int Dim>
bool addFunctionType(const std::string& type, FunctionFactory<Dim> factory) {
    return table<Dim>().emplace(type, factory).second;
}

std::vector<std::string> functionTypes() {
    std::vector<std::string> words;
    for (const auto& [word, factory] : table<2>()) words.push_back(word);
    return words;
}

template <int Dim>
State<Dim> initialState(const std::filesystem::path& root, const State<Dim>& state) {
    const auto times = listTimes(root).complete;
    if (state.time.index == 0 || times.empty() || times.front().value >= state.time.value) return state;
    return readState<Dim>(root / times.front().name);
}

template <int Dim>
std::unique_ptr<FunctionObject<Dim>> makeFunction(const Dictionary& dict, const FunctionContext<Dim>& context) {
    const auto type = dict.get<std::string>("type");
    const auto entry = table<Dim>().find(type);
    if (entry == table<Dim>().end()) dict.fatal("type", notValid(type, "function type", functionTypes()));
    dict.found("libs");  // accepted and ignored
    return entry->second(dict, context);
}

#define PFEM_INSTANTIATE(D)                                                           \
    template bool addFunctionType<D>(const std::string&, FunctionFactory<D>);         \
    template State<D> initialState<D>(const std::filesystem::path&, const State<D>&); \
    template std::unique_ptr<FunctionObject<D>> makeFunction<D>(const Dictionary&, const FunctionContext<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
