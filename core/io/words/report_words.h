#pragma once

#include "core/base/translate_noop.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/**
 * Language of a report. Its English texts are marked with QT_TRANSLATE_NOOP in context Report
 * (EventText for events); numbers have the format of files in every language.
 */
class ReportWords
{
public:
    /** Returns the translation of an English text, or the text itself. */
    using Lookup = std::function<std::string(std::string_view)>;

    /** Creates the words of an English report. */
    ReportWords() = default;
    explicit ReportWords(Lookup lookup);

    /** Returns the language tag for browsers, e.g. "nb". */
    [[nodiscard]] std::string tag() const;
    /** Translates a text and leaves %1, %2, ... in it. */
    [[nodiscard]] std::string translated(std::string_view english) const;
    /** Translates a text and fills in the arguments for %1, %2, ... */
    [[nodiscard]] std::string text(std::string_view english,
                                   const std::vector<std::string>& arguments = {}) const;
    /** Translates a text as HTML; the arguments must be HTML already. */
    [[nodiscard]] std::string html(std::string_view english,
                                   const std::vector<std::string>& arguments = {}) const;
    /** Translates each text as HTML, for table headers. */
    [[nodiscard]] std::vector<std::string>
    heads(const std::vector<std::string_view>& english) const;

private:
    Lookup m_lookup;
};

} // namespace berg
