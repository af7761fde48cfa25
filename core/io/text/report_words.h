#pragma once

#include "core/base/translate_noop.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/**
 * The language of a page for people. Its English texts are marked with QT_TRANSLATE_NOOP in
 * context Report (events: EventText); numbers are those of files in every language.
 */
class ReportWords
{
public:
    /** The translation of an English text, or the text itself. */
    using Lookup = std::function<std::string(std::string_view)>;

    /** English. */
    ReportWords() = default;
    explicit ReportWords(Lookup lookup);

    /** Of the language, for browsers: "nb". */
    [[nodiscard]] std::string tag() const;
    /** Without arguments: what %1, %2, ... stand for is put in elsewhere. */
    [[nodiscard]] std::string said(std::string_view english) const;
    /** With the arguments for %1, %2, ... */
    [[nodiscard]] std::string text(std::string_view english,
                                   const std::vector<std::string>& arguments = {}) const;
    /** The same as HTML, which the arguments are already. */
    [[nodiscard]] std::string html(std::string_view english,
                                   const std::vector<std::string>& arguments = {}) const;
    /** Each as HTML. */
    [[nodiscard]] std::vector<std::string>
    heads(const std::vector<std::string_view>& english) const;

private:
    Lookup m_lookup;
};

} // namespace berg
