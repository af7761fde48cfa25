#include "core/io/words/report_words.h"

#include "core/base/issue.h"
#include "core/io/text/html_text.h"

#include <utility>

namespace berg {

ReportWords::ReportWords(Lookup lookup) : m_lookup(std::move(lookup)) {}

std::string ReportWords::tag() const
{
    return translated(QT_TRANSLATE_NOOP("Report", "en"));
}

std::string ReportWords::translated(std::string_view english) const
{
    return m_lookup ? m_lookup(english) : std::string(english);
}

std::string ReportWords::text(std::string_view english,
                              const std::vector<std::string>& arguments) const
{
    return filledIn(translated(english), {arguments.begin(), arguments.end()});
}

std::string ReportWords::html(std::string_view english,
                              const std::vector<std::string>& arguments) const
{
    return filledIn(htmlText(translated(english)), {arguments.begin(), arguments.end()});
}

std::vector<std::string> ReportWords::heads(const std::vector<std::string_view>& english) const
{
    std::vector<std::string> heads;
    for (const std::string_view head : english)
        heads.push_back(html(head));
    return heads;
}

} // namespace berg
