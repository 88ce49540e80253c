#pragma once
// The text of a surface file, word by word with the line's number in every error. Internal to src/io.

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/types.hpp"

namespace pfem {

/// Lines that are neither empty nor a comment (#), as words.
class SurfaceLines {
public:
    SurfaceLines(const std::string& text, std::string name) : text_(text), name_(std::move(name)) {}

    bool next() {
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            split(std::string_view(text_).substr(at_, end - at_));
            at_ = end + 1;
            ++number_;
            if (!words.empty() && words[0][0] != '#') return true;
        }
        return false;
    }
    double real(std::size_t k) const {
        need(k + 1);
        std::string_view w = words[k];
        if (!w.empty() && w[0] == '+') w.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
        if (error != std::errc() || end != w.data() + w.size()) fail(fmt::format("'{}' is not a number", words[k]));
        if (!std::isfinite(value)) fail(fmt::format("'{}' is not a finite number", words[k]));
        return value;
    }
    long whole(std::string_view w) const {
        long value = 0;
        const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
        if (error != std::errc() || end != w.data() + w.size()) fail(fmt::format("'{}' is not a whole number", w));
        return value;
    }
    Vec<3> point(std::size_t k) const { return {real(k), real(k + 1), real(k + 2)}; }
    void need(std::size_t n) const {
        if (words.size() < n) fail(fmt::format("{} words expected, {} found", n, words.size()));
    }
    [[noreturn]] void fail(const std::string& message) const {
        throw UserError("cannot read the surface \"" + name_ + "\": " + message, {name_, number_});
    }

    std::vector<std::string_view> words;

private:
    void split(std::string_view line) {
        words.clear();
        std::size_t begin = 0;
        while ((begin = line.find_first_not_of(" \t\r", begin)) != std::string_view::npos) {
            const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
            words.push_back(line.substr(begin, end - begin));
            begin = end;
        }
    }

    const std::string& text_;
    std::string name_;
    std::size_t at_ = 0;
    int number_ = 0;
};

}  // namespace pfem
