#pragma once
// The content of a binary .msh file, read piece by piece; every error names the file.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/error.hpp"

namespace pfem {

/// A place in the content of a file. Both strings must outlive it.
class MshBytes {
public:
    MshBytes(const std::string& content, const std::string& name) : content_(content), name_(name) {}

    bool atEnd() const { return at_ >= content_.size(); }
    std::size_t at() const { return at_; }

    template <class T>
    T take() {
        T value;
        if (content_.size() - at_ < sizeof(T)) fail("the file ends too early");
        std::memcpy(&value, content_.data() + at_, sizeof(T));
        at_ += sizeof(T);
        return value;
    }
    /// How many things follow; each of them has a byte or more, so that damage cannot ask for endless memory.
    std::size_t takeCount() { return checked(take<std::uint64_t>()); }
    std::size_t countIn(const std::string& word) const { return checked(std::strtoull(word.c_str(), nullptr, 10)); }

    /// The rest of the line; steps over its end.
    std::string line() {
        std::string text = until(std::min(content_.find('\n', at_), content_.size()));
        at_ = std::min(at_ + 1, content_.size());
        if (!text.empty() && text.back() == '\r') text.pop_back();
        return text;
    }
    /// What comes before the next `mark`; stops at the mark.
    std::string before(const std::string& mark) {
        const auto found = content_.find(mark, at_);
        if (found == std::string::npos) fail("the file ends without " + mark);
        return until(found);
    }
    /// Steps over ends of lines and `mark`, which must be here.
    void expect(const std::string& mark) {
        at_ = std::min(content_.find_first_not_of("\r\n", at_), content_.size());
        if (content_.compare(at_, mark.size(), mark) != 0)
            fail(fmt::format("{} expected at byte {}: its counts are wrong", mark, at_));
        line();
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw UserError("cannot take the mesh of \"" + name_ + "\": " + message, {name_, 0});
    }

private:
    std::size_t checked(std::uint64_t count) const {
        if (count > content_.size() - at_) fail(fmt::format("{} is no number of things, before byte {}", count, at_));
        return count;
    }
    std::string until(std::size_t end) {
        const auto begin = at_;
        at_ = end;
        return content_.substr(begin, end - begin);
    }

    const std::string& content_;
    const std::string& name_;
    std::size_t at_ = 0;
};

}  // namespace pfem
