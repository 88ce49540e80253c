#include "parallel/ranks.hpp"

#include <mpi.h>

#include <cstdlib>
#include <limits>

#include "base/error.hpp"

namespace pfem {

namespace {

/// MPI is started when it is asked for first and ends with the program. Triangulations may be made by any thread.
void startMpi() {
    static const struct Session {
        Session() {
            int given = 0;
            MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &given);
            if (given < MPI_THREAD_SERIALIZED) throw UserError("-parallel needs an MPI that threads may call");
        }
        ~Session() { MPI_Finalize(); }
        Session(const Session&) = delete;
        Session& operator=(const Session&) = delete;
    } session;
}

/// One value of so many bytes.
class ValueType {
public:
    explicit ValueType(std::size_t bytes) {
        MPI_Type_contiguous(static_cast<int>(bytes), MPI_BYTE, &type_);
        MPI_Type_commit(&type_);
    }
    ~ValueType() { MPI_Type_free(&type_); }
    ValueType(const ValueType&) = delete;
    ValueType& operator=(const ValueType&) = delete;
    MPI_Datatype get() const { return type_; }

private:
    MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

/// `mine`: the values of this rank, or MPI_IN_PLACE where they stand in their place among `all`.
void allGather(const void* mine, void* all, int rank, const std::vector<std::size_t>& ends, std::size_t bytes) {
    const ValueType type(bytes);
    std::vector<int> counts(ends.size()), starts(ends.size());
    for (std::size_t r = 0; r < ends.size(); ++r) {
        starts[r] = r == 0 ? 0 : static_cast<int>(ends[r - 1]);
        counts[r] = static_cast<int>(ends[r]) - starts[r];
    }
    MPI_Allgatherv(mine, counts[rank], type.get(), all, counts.data(), starts.data(), type.get(), MPI_COMM_WORLD);
}

}  // namespace

Ranks Ranks::all() {
    startMpi();
    int rank = 0, size = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return {rank, size};
}

void Ranks::abort(int exitCode) const {
    if (!isAlone()) MPI_Abort(MPI_COMM_WORLD, exitCode);
    std::_Exit(exitCode);
}

void Ranks::broadcast(void* value, std::size_t bytes) const {
    MPI_Bcast(value, static_cast<int>(bytes), MPI_BYTE, 0, MPI_COMM_WORLD);
}

std::vector<std::size_t> Ranks::endsOf(std::size_t mine) const {
    std::vector<std::size_t> ends(size_);
    MPI_Allgather(&mine, sizeof mine, MPI_BYTE, ends.data(), sizeof mine, MPI_BYTE, MPI_COMM_WORLD);
    for (int rank = 1; rank < size_; ++rank) ends[rank] += ends[rank - 1];
    if (ends.back() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw InternalError("more values than MPI can count");
    return ends;
}

void Ranks::gather(const void* mine, void* all, const std::vector<std::size_t>& ends, std::size_t bytes) const {
    allGather(mine, all, rank_, ends, bytes);
}

void Ranks::gatherInPlace(void* all, const std::vector<std::size_t>& ends, std::size_t bytes) const {
    allGather(MPI_IN_PLACE, all, rank_, ends, bytes);
}

}  // namespace pfem
