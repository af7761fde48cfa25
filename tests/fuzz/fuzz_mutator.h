#pragma once

#include "core/base/random.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace berg::fuzz {

/** Damages texts in common and uncommon ways. */
class Mutator
{
public:
    /** `corpus` holds the texts to damage; their words are inserted elsewhere. */
    Mutator(std::uint64_t seed, const std::vector<std::string>& corpus)
        : m_random(seed, 77), m_corpus(corpus)
    {
        for (const std::string& text : corpus)
            learn(text);
    }

    [[nodiscard]] std::size_t below(std::size_t count) { return m_random.below(count); }

    [[nodiscard]] std::string mutated(std::string text)
    {
        for (std::size_t n = 1 + below(8); n > 0; --n)
            change(text);
        text.resize(std::min(text.size(), kLongest));
        return text;
    }

private:
    static constexpr std::size_t kLongest = 1U << 16U;

    /**
     * Collects words between quotes and of tags, limited per text so that other texts contribute
     * too.
     */
    void learn(std::string_view text)
    {
        const std::size_t mostWords = m_words.size() + 200;
        constexpr std::size_t kLongestWord = 40;
        for (std::size_t at = 0; m_words.size() < mostWords;) {
            at = text.find_first_of("\"<", at);
            if (at == std::string_view::npos)
                return;
            const std::size_t end = text.find_first_of("\">", at + 1);
            if (end != std::string_view::npos && end - at < kLongestWord)
                m_words.emplace_back(text.substr(at, end - at + 1));
            ++at;
        }
    }

    [[nodiscard]] std::size_t place(const std::string& text) { return below(text.size() + 1); }

    [[nodiscard]] std::string piece(const std::string& text)
    {
        const std::size_t from = place(text);
        return text.substr(from, below(below(8) == 0 ? 2000 : 30));
    }

    [[nodiscard]] std::string token()
    {
        static constexpr std::array<std::string_view, 57> kTokens{"\"",
                                                                  "\n",
                                                                  "\r\n",
                                                                  ",",
                                                                  ";",
                                                                  "\t",
                                                                  "|",
                                                                  "{",
                                                                  "}",
                                                                  "[",
                                                                  "]",
                                                                  ":",
                                                                  "<",
                                                                  ">",
                                                                  "/>",
                                                                  "&amp;",
                                                                  "&#0;",
                                                                  "<!DOCTYPE x>",
                                                                  "<![CDATA[",
                                                                  "]]>",
                                                                  "NaN",
                                                                  "Infinity",
                                                                  "1e308",
                                                                  "-1e308",
                                                                  "1e999",
                                                                  "-1e-320",
                                                                  "-0",
                                                                  "0",
                                                                  "-1",
                                                                  "1",
                                                                  "0.5",
                                                                  "180",
                                                                  "-180",
                                                                  "90.0000001",
                                                                  "9007199254740993",
                                                                  "18446744073709551616",
                                                                  "-9223372036854775808",
                                                                  "null",
                                                                  "true",
                                                                  "[]",
                                                                  "{}",
                                                                  "\\u0000",
                                                                  "\\ud800",
                                                                  "\xC3\xA9",
                                                                  "\xFF",
                                                                  "\x1b[31m",
                                                                  "2021-02-29T24:00:61Z",
                                                                  "05/02/2021",
                                                                  "=cmd|x",
                                                                  "-62.4S",
                                                                  "1,200",
                                                                  "\xC2\x9B",
                                                                  "\xE2\x80\xAE",
                                                                  "lat,lon,time\n",
                                                                  "QGC WPL 110\n",
                                                                  "\"version\": 2",
                                                                  "<coordinates>"};
        if (below(3) == 0 && !m_words.empty())
            return m_words[below(m_words.size())];
        if (below(20) == 0)
            return std::string(1, '\0');
        return std::string(kTokens[below(kTokens.size())]);
    }

    /** Replaces one of the numbers in the text by another. */
    void changeNumber(std::string& text)
    {
        constexpr std::string_view kDigits = "0123456789.-+eE";
        const std::size_t from = text.find_first_of("0123456789", place(text));
        if (from == std::string::npos)
            return;
        const std::size_t end = std::min(text.find_first_not_of(kDigits, from), text.size());
        text.replace(from, end - from, token());
    }

    /** Applies one random change. */
    void change(std::string& text)
    {
        const std::size_t at = place(text);
        switch (below(11)) {
        case 0:
            if (at < text.size())
                text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
            return;
        case 1:
            if (at < text.size())
                text[at] = static_cast<char>(below(256));
            return;
        case 2:
            text.erase(at, below(below(4) == 0 ? 500 : 8));
            return;
        case 3:
        case 4:
            text.insert(at, token());
            return;
        case 5:
        case 6:
            changeNumber(text);
            return;
        case 7:
            text.insert(at, piece(text));
            return;
        case 8:
            text.insert(at, piece(m_corpus[below(m_corpus.size())]));
            return;
        case 9: {
            const std::string repeated = below(2) == 0 ? token() : piece(text);
            for (std::size_t n = below(below(6) == 0 ? 300 : 6); n > 0 && text.size() < kLongest;
                 --n)
                text.insert(at, repeated);
            return;
        }
        default:
            if (below(4) == 0)
                text.resize(at);
        }
    }

    Random m_random;
    const std::vector<std::string>& m_corpus;
    std::vector<std::string> m_words;
};

} // namespace berg::fuzz
