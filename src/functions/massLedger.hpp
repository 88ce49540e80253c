#pragma once
// `type massLedger`: the fluid's mass and where its changes come from.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dictionary/entries.hpp"
#include "functions/functionObject.hpp"
#include "functions/massBalance.hpp"
#include "io/table.hpp"

namespace pfem {

struct MassLedgerEntries {
    bool writeFields = false;

    template <class Visitor>
    void entries(Visitor& v) {
        v("writeFields", writeFields, "-",
          "fluid.vtu of the run's time folders gets nodal fields (ledgerSolver, ledgerContact, ...): the volume that "
          "appeared "
          "around each node since the time folder before, by cause");
    }
};

/// Writes postProcessing/<name>/<startTime>/fluidVolume.dat: time, volume, mass (that of the volume without
/// compression), its relative change since the first time of the case, one column per cause of the ledger, their sum,
/// and what the sum leaves unexplained. The density is that of constant/materials.
template <int Dim>
class MassLedger : public FunctionObject<Dim> {
public:
    MassLedger(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;
    bool wantsAppeared() const override { return entries_.writeFields; }

private:
    void beginTable();

    FunctionContext<Dim> context_;
    MassLedgerEntries entries_;
    std::optional<MassAccount<Dim>> account_;
    std::filesystem::path file_;
    std::optional<double> rowsUntil_;  // the file holds the rows up to this time [s]
    std::vector<std::string> causes_;
    std::optional<Table> table_;
};

/// The names of the columns and one row, for the file and for pfemMassCheck.
std::vector<std::string> massTitles(const std::vector<std::string>& causes);
std::vector<double> massColumns(const MassBalance& balance, const std::vector<std::string>& causes);

/// All causes that occur in the rows, sorted.
std::vector<std::string> causesOf(const std::vector<MassBalance>& rows);

}  // namespace pfem
