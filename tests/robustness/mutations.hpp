#pragma once
// Seeded damage to texts and binary files.

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace pfem::test {

/// How many of a kind: from the environment, or the standard.
inline int countOf(const char* variable, int standard) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::atoi(text) : standard;
}

class Mutator {
public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    int below(std::size_t n) { return n == 0 ? 0 : static_cast<int>(random_() % n); }

    /// A dictionary with one to three mistakes: words lost, doubled, swapped or replaced, brackets in wrong places,
    /// numbers that make no sense, endless nesting, includes and macros of itself, the end cut off.
    std::string text(std::string text) {
        for (int n = 1 + below(3); n > 0; --n) text = mistake(text);
        return text;
    }

    /// A binary file with bytes flipped, lost, added or set, or its head edited.
    std::string bytes(std::string bytes) {
        for (int n = 1 + below(4); n > 0; --n) bytes = damage(bytes);
        return bytes;
    }

private:
    struct Word {
        std::size_t begin, length;
    };

    static std::vector<Word> words(const std::string& text) {
        const std::string other = " \t\n;(){}[]\"";
        std::vector<Word> found;
        for (std::size_t i = 0; i < text.size();) {
            const std::size_t begin = text.find_first_not_of(" \t\n", i);
            if (begin == std::string::npos) break;
            std::size_t end = text.find_first_of(other, begin);
            if (end == std::string::npos) end = text.size();
            if (end == begin) ++end;
            found.push_back({begin, end - begin});
            i = end;
        }
        return found;
    }

    std::string mistake(std::string text) {
        static const std::vector<std::string> values{"0",
                                                     "-1",
                                                     "1e300",
                                                     "-1e300",
                                                     "1e-300",
                                                     "nan",
                                                     "inf",
                                                     "1e",
                                                     "999999999999999999999999",
                                                     "0.5",
                                                     "-0",
                                                     "1e9",
                                                     "2147483648",
                                                     "(0 0)",
                                                     "(0 0 0)",
                                                     "()",
                                                     "(nan 0 0)",
                                                     "\"\"",
                                                     "yes",
                                                     "none",
                                                     "{}",
                                                     "[1 -3 0 0 0 0 0]",
                                                     "$self",
                                                     "$..x",
                                                     "${a",
                                                     "#eval \"1/0\"",
                                                     "#eval \"(((((\"",
                                                     "5{0.5}",
                                                     "1000000000{1}",
                                                     "#include \"controlDict\"",
                                                     "#remove rho",
                                                     "#{ code #}"};
        using namespace std::string_literals;
        static const std::string signs = "{}();\"$#/*[]\\|'\0\n\xff"s;
        const auto all = words(text);
        if (all.empty()) return "x";
        const Word w = all[below(all.size())], v = all[below(all.size())];
        switch (below(12)) {
            case 0:
                return text.erase(w.begin, w.length);
            case 1:
                return text.insert(w.begin, text.substr(w.begin, w.length) + " ");
            case 2:
                return text.replace(w.begin, w.length, text.substr(v.begin, v.length));
            case 3:
            case 4:
            case 5:
                return text.replace(w.begin, w.length, values[below(values.size())]);
            case 6:
                return text.insert(below(text.size()), 1, signs[below(signs.size())]);
            case 7:
                return text.substr(0, below(text.size()));
            case 8:
                return text.replace(below(text.size()), 1, 1, static_cast<char>(below(256)));
            case 9:
                return text.insert(w.begin, std::string(1 + below(20000), "({["[below(3)]));
            case 10:
                return text + "\nself $self;\nloop { $loop; }\n#include \"controlDict\"\n#include \"g\"\n";
            default:
                return text.erase(w.begin, below(300));
        }
    }

    std::string damage(std::string bytes) {
        if (bytes.empty()) return "x";
        const auto at = static_cast<std::size_t>(below(bytes.size()));
        const std::size_t head = std::min<std::size_t>(bytes.size(), 3000);
        switch (below(9)) {
            case 0:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
                return bytes;
            case 1:
                return bytes.substr(0, at);
            case 2:
                return bytes.erase(at, 1 + below(64));
            case 3:
                return bytes.insert(at, std::string(1 + below(64), static_cast<char>(below(256))));
            case 4:
                return bytes.replace(at, std::min<std::size_t>(8, bytes.size() - at), 8, "\xff\x7f\x01"[below(4) % 3]);
            case 5:
                return bytes.replace(at, std::min<std::size_t>(8, bytes.size() - at), 8, '\0');
            case 6: {  // a number in the head
                const auto digit = bytes.find_first_of("0123456789", below(head));
                if (digit < head) bytes[digit] = static_cast<char>('0' + below(10));
                return bytes;
            }
            case 7: {
                const auto digit = bytes.find_first_of("0123456789", below(head));
                if (digit < head) bytes.insert(digit, std::string(1 + below(12), '9'));
                return bytes;
            }
            default: {  // a name or type in the head
                const auto quote = bytes.find("=\"", below(head));
                if (quote < head)
                    bytes.insert(quote + 2, std::vector<std::string>{"x", "-", "Float32", "UInt8", "\""}[below(5)]);
                return bytes;
            }
        }
    }

    std::mt19937 random_;
};

}  // namespace pfem::test
